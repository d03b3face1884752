#include "appliance/core/performance/life_state.h"

#include <algorithm>
#include <initializer_list>

#include <glm/geometric.hpp>

namespace kaori::performance {
namespace {

// A look on its way is up to 300 m from her eyes (looking.cpp), and a target up to half of this.
constexpr float kFarPoint_m = 2 * show::kFarthestTarget_m;
// More than half a turn: the head goes a share of an angle that atan2 gave.
constexpr float kFarHead_rad = 4;
// Of a saccade or of the head; a head that turns by half a turn takes less than 1.5 s (saccade.h).
constexpr float kLongestMove_s = 10;

// False for NaN too: every comparison with it is.
bool Lie(std::initializer_list<float> values, float low, float high) {
  return std::ranges::all_of(values, [=](float v) { return v >= low && v <= high; });
}

bool LiesWithin(const glm::vec3& v, float far) {
  return Lie({glm::length(v)}, 0, far);
}

// Clocks stop at kLongSince_s. That of the head begins below 0, since the head follows the eyes a little
// later.
bool IsValidGaze(const GazeLife& g, std::size_t targets) {
  return LiesWithin(g.from_m, kFarPoint_m) && LiesWithin(g.to_m, kFarPoint_m) &&
         Lie({g.since_s, g.beyond_s, g.hand_off_s, g.head_hand_off_s}, 0, kLongSince_s) &&
         Lie({g.length_s, g.head_length_s}, 0, kLongestMove_s) && Lie({g.to_next_s}, -1, kLongSince_s) &&
         Lie({g.left_s}, 0, kLongSince_s) && Lie({g.head_since_s}, -1, kLongSince_s) &&
         Lie({g.share, g.head_share}, 0, 1) && g.away <= 1 && g.ahead <= 1 && g.target >= -1 &&
         g.target < static_cast<std::int32_t>(targets) &&
         Lie({g.head_from_rad.x, g.head_from_rad.y, g.head_to_rad.x, g.head_to_rad.y}, -kFarHead_rad,
             kFarHead_rad);
}

// Levels are 0 dB before the first frame; all else is within what accents.cpp writes.
bool IsValidAccent(const AccentLife& a) {
  return std::ranges::all_of(a.levels_db, [](float level) { return Lie({level}, -100, 0); }) &&
         Lie({a.step_s, a.brow}, 0, 1) && Lie({a.brow_s, a.nod_s, a.spoken_s, a.quiet_s}, 0, kLongSince_s);
}

}  // namespace

bool IsValidLife(const Life& life, std::size_t targets) {
  const auto amounts = [](const show::LifeAmounts& all) {
    return std::ranges::all_of(all, [](float amount) { return Lie({amount}, 0, show::kMostLife); });
  };
  return Lie({life.blinks.to_next}, -1, kLongSince_s) && Lie({life.blinks.to_second_s}, -1, kLongSince_s) &&
         IsValidGaze(life.gaze, targets) && IsValidAccent(life.accents) && amounts(life.called) &&
         amounts(life.now) && life.target >= -1 && life.target < static_cast<std::int32_t>(targets);
}

}  // namespace kaori::performance
