#include "appliance/core/performance/life.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/core/performance/blink.h"
#include "appliance/core/performance/ease.h"

namespace kaori::performance {
namespace {

constexpr float kTau = 6.2831853F;
// Fourteen breaths a minute, as of somebody at rest. Of this and all other waves, kLifePeriod_s holds a whole
// number, so that nothing jumps where the age begins anew.
constexpr float kBreath_hz = 0.23F;
constexpr float kQuiet = 0.02F;  // Below this the box plays nothing by itself.
// Two degrees each way.
constexpr float kGlance_rad = 0.035F;
// Hair as one spring: its own frequency, its damping as part of the critical one, how strongly the head's
// speed pulls it, and where it stops.
constexpr float kSpring_hz = 2.1F, kDamping = 0.32F, kSwingGain = 0.55F, kMaxSwing_rad = 0.35F;
constexpr float kStill_rad = 1e-4F;  // Swings that nobody sees end: a still show is a still picture.

// splitmix64 (Steele, Lea, Flood 2014), to 0..1: the same state gives the same life. 24 bits are what a float holds.
float Random(Life& life) {
  life.random += 0x9E3779B97F4A7C15U;
  std::uint64_t z = life.random;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return static_cast<float>((z ^ (z >> 31U)) >> 40U) / static_cast<float>(1U << 24U);
}

// A sine of -1..1; `phase` is in turns, so that waves that belong together do not run in step.
float Wave(float age_s, float hz, float phase) {
  return std::sin(kTau * (hz * age_s + phase));
}

// A countdown of 2.4 to 5.5 s lies between two blinks, and in one of eight cases one of 0.35 s. It runs 1.4
// times as fast as the clock at full life, and slower the lower the dial stands. While keys hold lids nothing
// blinks by itself.
void Blink(State& state, float amount, float dt_s) {
  state.life.to_next_blink_s -= dt_s * (0.4F + amount);
  if (state.life.to_next_blink_s > 0) return;
  const float chance = Random(state.life);
  state.life.to_next_blink_s = chance < 0.12F ? 0.35F : 2.0F + 3.5F * chance;  // Now and then twice.
  if (state.lids_held[0] + state.lids_held[1] > 0) return;
  for (float& since_s : state.blink_s) since_s = BlinkFrom(since_s);
}

// Somewhere new after 0.5 to 2.4 s, less far up and down than sideways. The gaze jumps there, as eyes do.
void Glance(State& state, float dt_s) {
  state.life.to_next_glance_s -= dt_s;
  if (state.life.to_next_glance_s > 0) return;
  state.life.to_next_glance_s = 0.5F + 1.9F * Random(state.life);
  state.life.glance_rad =
      glm::vec2(2 * Random(state.life) - 1, 1.2F * Random(state.life) - 0.6F) * kGlance_rad;
}

// How much the gaze stick has the eyes, 0..1: wholly from an eighth of a radian on.
float HandOnGaze(const State& state) {
  return std::min(1.0F, 8 * (std::abs(state.gaze.yaw_rad) + std::abs(state.gaze.pitch_rad)));
}

}  // namespace

// Several slow waves of unrelated length make a sway that nobody sees repeat; amplitudes are in radians.
Idle Live(State& state, float amount, float dt_s) {
  if (amount < kQuiet) return {};
  Blink(state, amount, dt_s);
  Glance(state, dt_s);
  const float t = state.age_s;
  const float breath = Wave(t, kBreath_hz, 0);
  Idle idle;
  idle.breath = amount * breath;
  idle.head.yaw_rad = amount * (0.022F * Wave(t, 0.11F, 0.2F) + 0.010F * Wave(t, 0.31F, 0.7F));
  idle.head.pitch_rad = amount * (0.012F * Wave(t, 0.13F, 0.5F) + 0.010F * breath);
  idle.head.roll_rad = amount * 0.014F * Wave(t, 0.083F, 0.9F);
  const float free = amount * (1 - HandOnGaze(state));
  // The eyes stay on the audience while the head sways.
  idle.gaze.yaw_rad = free * state.life.glance_rad.x - idle.head.yaw_rad;
  idle.gaze.pitch_rad = free * state.life.glance_rad.y - idle.head.pitch_rad;
  return idle;
}

// A damped spring that is pulled against the head's speed: angle'' = (0.12 pull - angle) w^2 - 2 d w angle'.
// The pull is the head's step over dt_s, so that a faster head swings the hair further whatever the frame rate.
void Swing(Sway& sway, const scene::Head& head, float dt_s) {
  if (dt_s <= 0) return;
  const glm::vec2 now(head.yaw_rad + head.roll_rad, head.pitch_rad);
  const glm::vec2 pull = (sway.head_rad - now) * (kSwingGain / dt_s);  // Against the head's speed.
  sway.head_rad = now;
  constexpr int kSteps = 4;  // Semi-implicit Euler is stable well beyond a frame of 100 ms / 4.
  const float omega = kTau * kSpring_hz;
  for (int i = 0; i < kSteps; ++i) {
    const float h = dt_s / kSteps;
    const glm::vec2 force =
        (pull * 0.12F - sway.angle_rad) * (omega * omega) - sway.speed_rad_s * (2 * kDamping * omega);
    sway.speed_rad_s += force * h;
    sway.angle_rad += sway.speed_rad_s * h;
  }
  if (pull == glm::vec2(0) && glm::length(sway.angle_rad) < kStill_rad &&
      glm::length(sway.speed_rad_s) < kStill_rad * omega)
    sway.angle_rad = sway.speed_rad_s = glm::vec2(0);
  sway.angle_rad = glm::clamp(sway.angle_rad, glm::vec2(-kMaxSwing_rad), glm::vec2(kMaxSwing_rad));
}

}  // namespace kaori::performance
