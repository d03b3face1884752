#include "appliance/core/performance/swing.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kaori::performance {
namespace {

constexpr float kTau = 6.2831853F;
// Hair as springs: their own frequencies by scene::HairPart, of which the short fringe has the highest and no two sides are alike;
// their damping as part of the critical one, how strongly the head's speed pulls them, and where they stop.
constexpr std::array<float, scene::kHairPartCount> kHair_hz{2.6F, 1.9F, 1.7F};
constexpr float kDamping = 0.32F, kHairGain = 0.066F, kMostHair_rad = 0.35F;
// Ears are heavier; their tips are light and follow faster.
constexpr float kUpper_hz = 1.6F, kLower_hz = 2.3F, kLowerDamping = 0.22F, kEarGain = 0.10F,
                kMostEar_rad = 0.6F;
// Towards the head, and the part of their speed with which they fall back from it.
constexpr float kToHead_rad = 0.04F, kFallsBack = 0.3F;
constexpr float kStill_rad = 1e-4F;  // Swings that nobody sees end: a still show is a still picture.
constexpr int kSteps = 4;            // Semi-implicit Euler is stable well beyond a frame of 100 ms / 4.

// How a spring answers: angle'' = (pulled_to - angle) w^2 - 2 d w angle'.
struct Spring {
  float omega;
  float damping;
};

// In kSteps equal steps. A spring at rest that is pulled nowhere ends.
void Move(Sway& sway, const Spring& spring, glm::vec2 pulled_to_rad, float dt_s) {
  const float h = dt_s / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const glm::vec2 force = (pulled_to_rad - sway.angle_rad) * (spring.omega * spring.omega) -
                            sway.speed_rad_s * (2 * spring.damping * spring.omega);
    sway.speed_rad_s += force * h;
    sway.angle_rad += sway.speed_rad_s * h;
  }
  if (pulled_to_rad == glm::vec2(0) && glm::length(sway.angle_rad) < kStill_rad &&
      glm::length(sway.speed_rad_s) < kStill_rad * spring.omega)
    sway.angle_rad = sway.speed_rad_s = glm::vec2(0);
}

// A spring that is pulled against the head's speed: the head's step over dt_s, so that a faster head swings it further
// whatever the frame rate.
void Lag(Sway& sway, const Spring& spring, glm::vec2 head_rad, float gain_s, float dt_s) {
  const glm::vec2 pull = (sway.head_rad - head_rad) * (gain_s / dt_s);
  sway.head_rad = head_rad;
  Move(sway, spring, pull, dt_s);
}

// `outwards` is 1 where outwards is +X, else -1.
void KeepOffHead(Sway& sway, float outwards) {
  if (sway.angle_rad.x * outwards > -kToHead_rad) return;
  sway.angle_rad.x = -kToHead_rad * outwards;
  if (sway.speed_rad_s.x * outwards < 0) sway.speed_rad_s.x *= -kFallsBack;
}

// Each way, of both directions.
void Bound(Sway& sway, float most_rad) {
  sway.angle_rad = glm::clamp(sway.angle_rad, glm::vec2(-most_rad), glm::vec2(most_rad));
}

}  // namespace

// A tilt moves the tips as a turn to the same side does; there is no other axis for either.
void SwingHair(std::array<Sway, scene::kHairPartCount>& parts, const scene::Head& head, float dt_s) {
  if (dt_s <= 0) return;
  const glm::vec2 now_rad(head.yaw_rad + head.roll_rad, head.pitch_rad);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    Lag(parts[part], {kTau * kHair_hz[part], kDamping}, now_rad, kHairGain, dt_s);
    Bound(parts[part], kMostHair_rad);
  }
}

// What hangs beside the axis of a turn goes forwards or backwards with it; a tilt takes both sides one way.
void SwingChains(std::array<Chain, 2>& sides, const scene::Head& head, float dt_s) {
  if (dt_s <= 0) return;
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const float outwards = side == 0 ? 1.0F : -1.0F;
    Chain& chain = sides[side];
    Lag(chain.upper, {kTau * kUpper_hz, kDamping}, {head.roll_rad, head.pitch_rad - outwards * head.yaw_rad},
        kEarGain, dt_s);
    KeepOffHead(chain.upper, outwards);
    Bound(chain.upper, kMostEar_rad);
    Move(chain.lower, {kTau * kLower_hz, kLowerDamping}, chain.upper.angle_rad, dt_s);
    KeepOffHead(chain.lower, outwards);
    Bound(chain.lower, kMostEar_rad);
  }
}

}  // namespace kaori::performance
