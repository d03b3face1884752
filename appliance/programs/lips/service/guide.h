// A calibration by keyboard and lamps at the box, without a page: hold F12, make a face, push, four times.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/service/tuning.h"
#include "drivers/base/clock.h"

namespace kaori::lips {

// F12 held for two seconds begins it, or Insert, which no browser takes for itself. Where no clean mouth is
// seen the paint is looked for first, and the camera may find its light anew. Enter, or any push on the dial
// box, takes the pose that the lamp of its number asks for (shut, open, wide, narrow), and at last keeps all
// of it on the disk. Escape, or a minute in which nobody pushes, leaves, and all is as before.
class Guide {
 public:
  // What the hands are doing, and how well the mouth is seen now.
  void Step(const board::Stamped<board::Keys>& keys, const board::Stamped<board::Surface>& surface,
            float quality, Tuning& tuning, Time now);

  bool active() const { return active_; }
  board::LipsGuide shown(bool captions) const;

 private:
  struct Pushes {
    std::uint32_t takes = 0;
    std::uint32_t escapes = 0;
    bool operator==(const Pushes&) const = default;
  };
  static Pushes PushesOf(const board::Keys& keys, const board::Surface& surface);
  void Start(float quality, Tuning& tuning, Time now);
  void Follow(Tuning& tuning, Time now);
  void BeginPose(Tuning& tuning, Time now);
  void Leave(Tuning& tuning);

  bool active_ = false;
  std::uint32_t step_ = 0;  // As board::LipsGuide has it.
  bool taking_ = false;
  bool seen_ = false;
  float progress_ = 0;
  std::uint32_t before_ = 0;        // Changes there were when it began,
  std::uint32_t before_step_ = 0;   // and when the pose was taken.
  std::optional<Time> held_since_;  // F12 or Insert.
  bool let_go_ = true;
  Pushes seen_pushes_;
  Time idle_since_{};
};

}  // namespace kaori::lips
