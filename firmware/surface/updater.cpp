#include "firmware/surface/updater.h"

#include <algorithm>

namespace kaori::surface {

// An image of another device or of a time before `oldest_version` is refused, and so is a second update while
// the running one is on trial: the other slot is all there is to go back to.
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

// Bytes come in order and without gaps; pages of flash are written as they fill. A page that does not read
// back as it was written ends the update, and the host has to begin again.
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

// A sector is erased when its first page comes, so that no command waits for more than one of them.
bool Updater::WritePage() {
  const std::uint32_t begin = (taken_ - 1) / kPageBytes * kPageBytes;
  const std::uint32_t at = ImageAt(Other(running_.slot)) + begin;
  const auto page = std::span(page_).first(taken_ - begin);
  if (at % kSectorBytes == 0) flash_.Erase(at);
  flash_.Program(at, page);
  return std::ranges::equal(flash_.Read(at, page.size()), page);
}

// The header makes the slot a choice of the next start. It is written only after the hash of all that lies in
// flash, and not of what came over the cable, was found right.
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

// An image on trial says so until the box has told it to stay (kKeep).
wire::SurfaceState Updater::state() const {
  if (step_ == Step::kTaking) return wire::SurfaceState::kUpdates;
  if (step_ == Step::kWhole) return wire::SurfaceState::kReady;
  return IsKept(flash_, running_.slot) ? wire::SurfaceState::kPlays : wire::SurfaceState::kTries;
}

}  // namespace kaori::surface
