// Where she looks by herself: at somebody in bursts, aside between them, and the head that follows.
#pragma once

#include <array>

#include "appliance/core/performance/aim.h"
#include "appliance/core/performance/state.h"

namespace kaori::performance {

// What her look depends on in this frame.
struct LookInput {
  glm::vec3 house_m{};                // Whom she looks at while nobody is named,
  glm::vec3 target_m{};               // and whom a cue named, where state.life.target is not -1.
  std::array<glm::vec3, 2> eyes_m{};  // With the head at rest.
  glm::vec3 pivot_m{};
  scene::Head head{};          // Without what follows the eyes.
  float glance = 0, turn = 0;  // Amounts of glances and of the head's following; 1 is as people do.
  bool hand_on_eyes = false;   // A stick or a motion moves them: she does not.
  bool hand_on_head = false;
};

// What this frame adds to the head and to each eye; and the gaze's movement that began within the frame.
struct Look {
  glm::vec2 head_rad{};  // Yaw, pitch.
  std::array<scene::Gaze, 2> eyes{};
  float moved_rad = 0;  // 0: none began.
  float ago_s = 0;      // Before the end of the frame.
};

// Moves her look on by dt_s. Saccades begin at their own time, whatever the rate of frames, at least 0.2 s
// apart, and hold their point while the head moves. Eyes are given up to a hand within 0.25 s, and taken up
// again by a saccade when it has let go. Allocates nothing.
Look LookAround(GazeLife& life, std::int32_t target, const LookInput& input, float dt_s);

}  // namespace kaori::performance
