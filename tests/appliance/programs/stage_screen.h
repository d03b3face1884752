// A screen that a test holds: it is plugged and pulled, changes its size, and flips when it is told to.
#pragma once

#include <sys/eventfd.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/scanout.h"

namespace kaori::tests {

// The test's side; it outlives the screen.
struct ScreenHand {
  int width_px = 64;
  int height_px = 36;
  bool plugged = true;
  std::uint64_t presented = 0;  // The number of the last frame.
  Duration takes{};             // So much of this clock's time a frame takes until it is presented.
  ManualClock* clock = nullptr;
  std::optional<ports::Flip> flip;
  std::vector<std::uint8_t> picture = std::vector<std::uint8_t>(512 * 512 * 4);

  bool Shows() const {
    for (const std::uint8_t byte : picture)
      if (byte != 0) return true;
    return false;
  }
};

class HeldScreen final : public ports::Scanout {
 public:
  explicit HeldScreen(ScreenHand& hand) : hand_(hand), event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

  int pollable() const override { return event_.get(); }

  Result<ports::PixelBuffer> Acquire() override {
    if (!hand_.plugged) return Gone();
    const auto bytes = static_cast<std::size_t>(hand_.width_px * hand_.height_px) * 4;
    return ports::PixelBuffer{hand_.width_px, hand_.height_px,
                              ports::PixelMemory{std::span(hand_.picture).first(bytes)}};
  }

  Result<void> Present(std::uint64_t frame) override {
    if (!hand_.plugged) return Gone();
    hand_.presented = frame;
    if (hand_.clock != nullptr) hand_.clock->Advance(hand_.takes);
    return {};
  }

  Result<ports::Flip> ReadFlip() override {
    if (!hand_.plugged) return Gone();
    if (!hand_.flip) return Fail(std::errc::resource_unavailable_try_again, "read a flip");
    const ports::Flip flip = *hand_.flip;
    hand_.flip.reset();
    return flip;
  }

 private:
  static tl::unexpected<Error> Gone() { return Fail(std::errc::no_such_device, "the held screen"); }

  ScreenHand& hand_;
  UniqueFd event_;
};

}  // namespace kaori::tests
