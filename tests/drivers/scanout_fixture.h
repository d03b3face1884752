// The screens of a fake graphics card, and frames on them.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "drivers/scanout/kms_screen.h"
#include "tests/drivers/scanout_fake_card.h"

namespace kaori::tests {

class Screens : public ::testing::Test {
 protected:
  using KmsScreen = scanout::KmsScreen;

  Result<std::unique_ptr<KmsScreen>> TryOpen() {
    const auto make = [this](int width_px, int height_px) -> Result<std::unique_ptr<scanout::KmsSurface>> {
      if (width_px > largest_px_) return Fail(std::errc::not_enough_memory, "make a surface");
      size_px_ = {width_px, height_px};
      return std::make_unique<FakeSurface>(card_, next_framebuffer_ += 10);
    };
    return KmsScreen::Open(card_, make, clock_, preferences_);
  }
  std::unique_ptr<KmsScreen> Open() { return TryOpen().value(); }

  // A whole frame, from Acquire to its flip.
  Result<ports::Flip> Frame(KmsScreen& screen) {
    if (auto drawn = screen.Acquire(); !drawn) return tl::unexpected(drawn.error());
    if (auto shown = screen.Present(++frame_); !shown) return tl::unexpected(shown.error());
    clock_.Advance(std::chrono::milliseconds(16));
    card_.Blank(clock_.now());
    return screen.ReadFlip();
  }
  // Frames for so long; the first fault ends them.
  Result<void> Frames(KmsScreen& screen, Duration length) {
    for (const Time end = clock_.now() + length; clock_.now() < end;)
      if (auto flip = Frame(screen); !flip) return tl::unexpected(flip.error());
    return {};
  }
  std::uint64_t Source(std::size_t crtc, const char* name) const {
    return card_.Value(FakeCard::kFirstPlane + std::uint32_t(crtc), name) >> 16;
  }

  FakeCard card_{3, 3};
  ManualClock clock_;
  scanout::KmsPreferences preferences_;
  std::pair<int, int> size_px_;
  std::uint32_t next_framebuffer_ = 1000;
  std::uint64_t frame_ = 0;
  int largest_px_ = 1 << 20;  // A wider surface gets no memory.
};

}  // namespace kaori::tests
