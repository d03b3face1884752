// The calibration by keyboard and lamps at the box, without a page: hold F12, then hold four poses and push
// for each. What the operator sees of it are the lamps of buttons 1 to 4, and captions where the screen may
// show them (stage/service_display.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/service/tuning.h"
#include "drivers/base/clock.h"

namespace kaori::lips {

// F12, or Insert, which no browser uses itself, begins a calibration when it is held for two seconds. Where
// no clean mouth is seen, the paint is sampled first, and the camera may adjust its exposure. Enter, or any
// push on the dial box, measures the pose whose lamp is lit (shut, open, wide, narrow); the fifth push saves
// all of it to the disk. Escape, or a minute without a push, cancels the calibration and restores the
// settings. Pure: time is in the arguments. It commands the Tuning as a desk does; both may be at work, and
// each sees what the other changed. One thread.
class Guide {
 public:
  // Handles the operator's input and the mouth as it is measured now. Call it every 50 ms or sooner. While it
  // is active, the stage takes these presses out of the show (stage/service_display.h).
  void Step(const board::Stamped<board::Keys>& keys, const board::Stamped<board::Surface>& surface,
            const board::Lips& lips, Tuning& tuning, Time now);

  // A calibration by keys is under way.
  bool active() const { return active_; }
  // The state for the board; `captions` allows the screen to show it in words.
  board::LipsGuide state(bool captions) const;

 private:
  // Sums of counters on the board: pushes that confirm, and pushes of Escape.
  struct Pushes {
    std::uint32_t confirms = 0;
    std::uint32_t cancels = 0;
    bool operator==(const Pushes&) const = default;
  };
  static Pushes PushesOf(const board::Keys& keys, const board::Surface& surface);
  // Begins with the first pose. The exposure is freed, and where the mouth is not clean the paint is looked
  // for.
  void Start(const board::Lips& lips, Tuning& tuning, Time now);
  // Goes on to the next pose when one is measured.
  void FollowStep(Tuning& tuning, Time now);
  // Measures the pose that is due, or saves after the last one.
  void BeginPose(Tuning& tuning, Time now);
  // Undoes what this calibration has changed.
  void Abandon(Tuning& tuning);

  bool active_ = false;
  std::uint32_t step_ = 0;  // As in board::LipsGuide.
  // A pose is being measured; a learnable mouth is seen now; how far the measurement is.
  bool measurement_ = false;
  bool seen_ = false;
  float progress_ = 0;
  std::uint32_t before_ = 0;        // How many changes there were when the calibration began,
  std::uint32_t before_step_ = 0;   // and when the measurement of the pose began.
  std::optional<Time> held_since_;  // Since when F12 or Insert is held.
  bool released_ = true;            // The key was released since the last calibration began.
  Pushes seen_pushes_;
  // When something was last pushed or measured.
  Time idle_since_{};
};

}  // namespace kaori::lips
