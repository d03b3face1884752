// What scenes and cues say of the face's own life: how much of each part there is, and whom she looks at.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace kaori::show {

// The parts of what the face does by itself. The Life dial lies over all of them.
enum class LifePart : std::uint8_t {
  kBlink,    // How often she blinks.
  kGlance,   // How often and how far she looks away from whom she looks at.
  kHead,     // How far the head follows the eyes, and sways.
  kBreath,   // Breath and pupils.
  kAccents,  // Brows and nods with the voice.
};
inline constexpr std::size_t kLifePartCount = 5;

// One amount for each part: 0 nothing, 1 as people do, up to kMostLife.
using LifeAmounts = std::array<float, kLifePartCount>;
inline constexpr LifeAmounts kWholeLife{1, 1, 1, 1, 1};
inline constexpr float kMostLife = 2;
// In a cue: the part stays as it was.
inline constexpr float kKeepsLife = -1;

inline float AmountOf(const LifeAmounts& amounts, LifePart part) {
  return amounts[static_cast<std::size_t>(part)];
}

// A point of the stage that she can look at. Metres, in the cast's frame: from the middle of her head at the
// height of her eyes, x to her left, y up, z to the audience.
struct GazeTarget {
  std::string name;
  glm::vec3 at_m{};
};
inline constexpr std::size_t kMostGazeTargets = 256;
// Nearer ones would cross her eyes; none of them may lie behind her.
inline constexpr float kNearestTarget_m = 0.4F, kFarthestTarget_m = 200;
// Nor farther aside than 60 degrees: the tangent of it.
inline constexpr float kSteepestTarget = 1.7320508F;
inline constexpr std::int32_t kNoTarget = -1;
// Whether it can be looked at. False for numbers that are none.
bool IsTarget(const glm::vec3& at_m);

// The first of a show's targets is the house: whom she looks at while nobody else is named. Where a show has
// no targets at all, it is four metres ahead.
inline constexpr const char* kHouseName = "house";
inline constexpr glm::vec3 kHouse_m{0, 0, 4};
inline glm::vec3 HouseOf(const std::vector<GazeTarget>& targets) {
  return targets.empty() ? kHouse_m : targets.front().at_m;
}

}  // namespace kaori::show
