// What the performance remembers of the face's own life. Plain bytes, a part of State.
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "appliance/core/performance/random.h"
#include "appliance/core/show/life.h"

namespace kaori::performance {

// Clocks of seconds stop here: whatever they measure is long over.
inline constexpr float kLongSince_s = 10;

struct BlinkLife {
  RandomStream random{0x9E3779B97F4A7C15U};
  float to_next =
      0.7F;  // Until the next blink, in mean intervals, so that a change of the rate counts at once.
  float to_second_s = -1;  // Until the second one of a double blink; below 0: there is none.
};

// Where she looks, as points of the stage (show::GazeTarget), and the turn of the head that belongs to it.
struct GazeLife {
  RandomStream random{0x6A09E667F3BCC909U};
  // The last saccade: between two points, begun since_s ago, length_s long.
  glm::vec3 from_m{0, 0, 4}, to_m{0, 0, 4};
  float since_s = kLongSince_s, length_s = 0;
  float to_next_s = 1;              // Until the next fixation,
  float left_s = 1;                 // and until this burst of looking, at somebody or away, is over.
  std::uint32_t away = 0;           // 1: glances beside the one whom she looks at.
  std::uint32_t ahead = 0;          // 1: the head is turned away too far; she looks where it points.
  std::int32_t target = -1;         // Whom she looks at, of the show's targets; -1: nobody was named.
  float beyond_s = 0;               // For how long the target has been beyond the eyes' reach.
  float share = 0;                  // Of her own life in the eyes: 0 a hand or nothing moves them .. 1.
  float hand_off_s = kLongSince_s;  // Since a hand or a motion moved the eyes.
  // How the head follows: yaw and pitch. Before it begins since_s is below 0.
  glm::vec2 head_from_rad{}, head_to_rad{};
  float head_since_s = kLongSince_s, head_length_s = 0;
  float head_share = 1;                  // As `share`, of the head.
  float head_hand_off_s = kLongSince_s;  // Since a hand moved the head.
};

// What the voice has done to brows and head, and how long ago. Plain bytes, as all of Life.
struct AccentLife {
  // The voice's level over the last tenth of a second, in steps of 10 ms, the newest first; and the time
  // within the step.
  std::array<float, 11> levels_db{};
  float step_s = 0;
  float brow = 0;                // How far the last accent raises the brows,
  float brow_s = kLongSince_s;   // and when it began.
  float nod_s = kLongSince_s;    // Since the last nod began.
  float spoken_s = 0;            // How long the phrase has lasted; 0: none is under way.
  float quiet_s = kLongSince_s;  // Since somebody spoke.
};

struct Life {
  BlinkLife blinks;
  GazeLife gaze;
  AccentLife accents;
  show::LifeAmounts called = show::kWholeLife;  // As scenes and cues have it,
  show::LifeAmounts now = show::kWholeLife;     // and on its way there.
  std::int32_t target = -1;  // Whom a scene or a cue lets her look at, of the show's targets; -1: nobody.
};

// Whether every number is one that this program writes. Points are bounded; `targets` is how many the show
// has.
bool IsValidLife(const Life& life, std::size_t targets);

}  // namespace kaori::performance
