// When to begin a frame: so late that its hands are as fresh as drawing allows, so early that its flip is not
// missed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "drivers/base/clock.h"
#include "drivers/ports/scanout.h"

namespace kaori::stage {

// Pure: told of flips and of drawing, asked for plans; reads no clock. All its lengths are fractions of the
// screen's period, so that it holds for any screen.
class FramePacer {
 public:
  struct Plan {
    Time begin{};  // Read the hands and draw then.
    Time light{};  // The vertical blank at which the frame will be seen.
  };

  // Off: each frame begins right after the flip before it.
  void Set(bool late) { late_ = late; }

  // Another screen: what was learnt is forgotten but for the count of missed flips.
  void Forget();

  // A frame came to light.
  void Flipped(const ports::Flip& flip);

  // The frame of `plan` was handed to the screen at `done`.
  void Drawn(const Plan& plan, Time done);

  // For the next frame, of which nothing was begun yet. At once, where no flip was seen so far.
  Plan Next(Time now) const;

  // Flips that came later than was aimed at.
  std::uint32_t missed() const { return missed_; }
  // What is held ready beyond the usual time of drawing.
  Duration margin() const { return margin_; }
  // The usual time from the beginning of a frame until the screen has it: the median of the newest frames.
  Duration usual() const;

 private:
  Time BlankAfter(Time at) const;
  void Widen();
  void Narrow();
  Duration longest() const;

  static constexpr std::size_t kRemembered = 31;
  bool late_ = true;
  std::optional<ports::Flip> last_;
  std::optional<Time> aimed_;  // At which blank the frame should be seen that the screen has.
  std::array<Duration, kRemembered> spent_{};
  std::size_t drawn_ = 0;
  Duration margin_{};
  std::uint32_t missed_ = 0;
};

}  // namespace kaori::stage
