#include "firmware/surface/updater.h"

#include <algorithm>

namespace kaori::surface {

bool Updater::Begin(const wire::SurfaceImage& image) {
  if (image.product != running_.product || image.version < running_.oldest_version) return false;
  if (image.length == 0 || image.length > kMostImageBytes) return false;
  if (!IsKept(flash_, running_.slot)) return false;
  // From here on the other slot has no header, and is nobody's choice.
  flash_.Erase(At(Other(running_.slot)));
  image_ = image;
  taken_ = 0;
  step_ = Step::kTaking;
  return true;
}

bool Updater::Data(std::uint32_t offset, std::span<const std::uint8_t> bytes) {
  if (step_ != Step::kTaking || offset != taken_) return false;
  if (bytes.size() > image_.length - taken_) return false;
  for (const std::uint8_t byte : bytes) {
    page_[taken_ % kPageBytes] = byte;
    ++taken_;
    const bool page_ends = taken_ % kPageBytes == 0 || taken_ == image_.length;
    if (page_ends && !WritePage()) {
      step_ = Step::kIdle;
      return false;
    }
  }
  return true;
}

bool Updater::WritePage() {
  const std::uint32_t begin = (taken_ - 1) / kPageBytes * kPageBytes;
  const std::uint32_t at = ImageAt(Other(running_.slot)) + begin;
  const auto page = std::span(page_).first(taken_ - begin);
  if (at % kSectorBytes == 0) flash_.Erase(at);
  flash_.Program(at, page);
  return std::ranges::equal(flash_.Read(at, page.size()), page);
}

bool Updater::End() {
  const Slot slot = Other(running_.slot);
  if (step_ != Step::kTaking || taken_ != image_.length) return false;
  step_ = Step::kIdle;
  if (!HasItsHash(flash_, slot, image_)) return false;
  WriteHeader(flash_, slot, {.generation = NextGeneration(), .image = image_});
  const auto written = ReadHeader(flash_, slot);
  if (!written || written->image != image_) return false;
  step_ = Step::kWhole;
  return true;
}

// The slot that runs has a header, or it would not run.
std::uint32_t Updater::NextGeneration() const {
  const auto header = ReadHeader(flash_, running_.slot);
  return header ? header->generation + 1 : 1;
}

wire::SurfaceState Updater::state() const {
  if (step_ == Step::kTaking) return wire::SurfaceState::kUpdates;
  if (step_ == Step::kWhole) return wire::SurfaceState::kReady;
  return IsKept(flash_, running_.slot) ? wire::SurfaceState::kPlays : wire::SurfaceState::kTries;
}

}  // namespace kaori::surface
