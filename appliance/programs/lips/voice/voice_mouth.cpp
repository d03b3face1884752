#include "appliance/programs/lips/voice/voice_mouth.h"

#include <algorithm>
#include <cmath>

namespace kaori::voice {
namespace {

constexpr float kQuiet_db = -46,
                kLoud_db = -26;      // Between these levels the mouth opens from kWhisper to wholly.
constexpr float kWhisper = 0.35F;    // How far a whisper opens it.
constexpr float kConsonant = 0.25F;  // How far a sound that is no vowel opens it.
constexpr double kHeightHalfLife_s = 0.008;
constexpr double kWidthHalfLife_s = 0.02;  // Lips become round slower than they open.
constexpr Duration kLongestGap = std::chrono::seconds(1);

// From kWhisper to 1, straight over the level in dB.
float Loud(float level_db) {
  const float way = std::clamp((level_db - kQuiet_db) / (kLoud_db - kQuiet_db), 0.0F, 1.0F);
  return kWhisper + (1 - kWhisper) * way;
}

// Silence shuts the mouth at its rest width; a sound that is no vowel opens it a little and leaves the width
// as it is, since consonants say nothing about it.
MouthShare TargetOf(const Voice& voice, float width_now) {
  if (!voice.speaking) return {0, 0.5F};
  if (!voice.vowel) return {kConsonant * Loud(voice.level_db), width_now};
  return {voice.vowel->mouth.height * Loud(voice.level_db), voice.vowel->mouth.width};
}

void Approach(float& now, float target, double dt_s, double half_life_s) {
  now = std::clamp(target + (now - target) * static_cast<float>(std::exp2(-dt_s / half_life_s)), 0.0F, 1.0F);
}

}  // namespace

// The time since the last block sets how far the mouth goes, so that blocks of any length give the same
// mouth.
const board::Voice& VoiceMouth::Follow(const Voice& voice) {
  const Duration gap = std::clamp(voice.at - at_, Duration::zero(), kLongestGap);
  at_ = voice.at;
  const MouthShare target = TargetOf(voice, mouth_.width);
  Approach(mouth_.height, target.height, Seconds(gap), kHeightHalfLife_s);
  Approach(mouth_.width, target.width, Seconds(gap), kWidthHalfLife_s);
  mouth_.level_db = voice.level_db;
  mouth_.speaking = voice.speaking ? 1 : 0;
  mouth_.quality = 0;
  if (voice.vowel) mouth_.quality = std::clamp(*std::ranges::max_element(voice.vowel->likely), 0.0F, 1.0F);
  ++mouth_.blocks;
  return mouth_;
}

}  // namespace kaori::voice
