#include "appliance/programs/lips/voice/voice_mouth.h"

#include <algorithm>
#include <cmath>

namespace kaori::voice {
namespace {

constexpr float kQuiet_db = -46, kLoud_db = -26;  // Between them a mouth opens from little to wholly.
constexpr float kLeast = 0.35F;                   // How far a whisper opens it.
constexpr float kConsonant = 0.25F;               // How far what is no vowel opens it.
constexpr double kHeightHalfLife_s = 0.008;
constexpr double kWidthHalfLife_s = 0.02;  // Lips round slower than they open.
constexpr Duration kLongestGap = std::chrono::seconds(1);

float Loud(float level_db) {
  const float way = std::clamp((level_db - kQuiet_db) / (kLoud_db - kQuiet_db), 0.0F, 1.0F);
  return kLeast + (1 - kLeast) * way;
}

MouthShare Goal(const Voice& voice, float width_now) {
  if (!voice.speaking) return {0, 0.5F};
  if (!voice.vowel) return {kConsonant * Loud(voice.level_db), width_now};
  return {voice.vowel->mouth.height * Loud(voice.level_db), voice.vowel->mouth.width};
}

void Approach(float& now, float goal, double dt_s, double half_life_s) {
  now = std::clamp(goal + (now - goal) * static_cast<float>(std::exp2(-dt_s / half_life_s)), 0.0F, 1.0F);
}

}  // namespace

const board::Voice& VoiceMouth::Follow(const Voice& voice) {
  const Duration gap = std::clamp(voice.at - at_, Duration::zero(), kLongestGap);
  at_ = voice.at;
  const MouthShare goal = Goal(voice, mouth_.width);
  Approach(mouth_.height, goal.height, Seconds(gap), kHeightHalfLife_s);
  Approach(mouth_.width, goal.width, Seconds(gap), kWidthHalfLife_s);
  mouth_.level_db = voice.level_db;
  mouth_.speaking = voice.speaking ? 1 : 0;
  mouth_.quality = 0;
  if (voice.vowel) mouth_.quality = std::clamp(*std::ranges::max_element(voice.vowel->likely), 0.0F, 1.0F);
  ++mouth_.blocks;
  return mouth_;
}

}  // namespace kaori::voice
