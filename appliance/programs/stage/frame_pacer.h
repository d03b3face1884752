// When to begin a frame: so late that its input is as fresh as drawing allows, so early that its flip is not
// missed. "Late latching" of input is the same idea.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "drivers/base/clock.h"
#include "drivers/ports/scanout.h"

namespace kaori::stage {

// Pure: it is told of flips and of drawing and asked for plans, and reads no clock. All its lengths are
// fractions of the screen's period, so that it holds for any screen. One thread; allocates nothing. The calls
// for one frame come in the order Next, Drawn, Flipped.
//
//   last flip            begin = blank - usual - margin      presented_at = blank
//       |---------------------|-------- usual --------|-- margin --|
//             waiting            sample, draw, Present    in hand
//
// The blank is the first one that a frame begun now would usually reach; where the time is short it begins at
// once.
class FramePacer {
 public:
  struct Plan {
    Time begin{};         // When to sample the input and to draw.
    Time presented_at{};  // The vertical blank at which the frame's scan-out begins.
  };

  // Off: each frame begins right after the flip before it.
  void Set(bool late) { late_ = late; }

  // To be called for another screen: all that was learnt is forgotten but for the count of missed flips. A
  // plan that was given before stands for the old screen and is not to be drawn by.
  void Forget();

  // To be called when a frame is presented. `flip` says when scan-out began (CLOCK_MONOTONIC, the kernel's
  // stamp) and the period. Counts the flip as missed where it came half a period or more after the blank that
  // its frame was aimed at.
  void Flipped(const ports::Flip& flip);

  // To be called when the frame of `plan` has been handed to the screen, at `done`. Each plan is handed in
  // once. A `done` before the plan's begin counts as no time at all.
  void Drawn(const Plan& plan, Time done);

  // The plan for the next frame, of which nothing was begun yet: at once, where no flip was seen so far.
  // Changes nothing: asking again later gives a later plan.
  Plan Next(Time now) const;

  // How many flips came later than was aimed at.
  std::uint32_t missed() const { return missed_; }
  // What is kept in hand beyond the usual time of drawing: between a sixteenth of the period and a whole one.
  Duration margin() const { return margin_; }
  // The usual time from the beginning of a frame until the screen has it: the median of the newest 15 frames;
  // 0 before the first.
  Duration usual() const;

 private:
  // The first vertical blank at or after `at` that lies behind the last flip.
  Time BlankAfter(Time at) const;
  // One step wider, or narrower; both keep the margin within its bounds.
  void Widen();
  void Narrow();
  // The longest of the frames that are remembered.
  Duration longest() const;

  static constexpr std::size_t kRemembered = 31;
  bool late_ = true;
  std::optional<ports::Flip> last_;
  std::optional<Time> aimed_;  // The blank at which the frame that the screen has should be presented.
  // How long the newest frames took, as a ring; drawn_ counts all since Forget.
  std::array<Duration, kRemembered> spent_{};
  std::size_t drawn_ = 0;
  Duration margin_{};
  std::uint32_t missed_ = 0;
};

}  // namespace kaori::stage
