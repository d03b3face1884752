#include "hw-sim/devices/voice_synth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kaori::sim {
namespace {

// A man's voice.
constexpr double kPitch_hz = 125;
constexpr double kGlottis_hz = 100;  // Above it a pulse falls by 12 dB an octave.
// Samples from one move of the throat to the next: cosines are too dear for every sample.
constexpr int kShape = 32;
// How fast the resonances glide from vowel to vowel, and the loudness rises.
constexpr double kGlide_s = 0.012;
constexpr double kAttack_s = 0.002;
// Over so long the voice's own level is measured: some periods of the pitch.
constexpr double kLevel_s = 0.03;
constexpr double kLoud = 0.1;               // RMS of full scale at loudness 1.
constexpr double kVoiceSynthRoom = 0.0003;  // A quiet room: -70 dB.
// Keeps the level from being divided by zero while it is measured for the first time.
constexpr double kLeast = 1e-9;

// Where Japanese vowels resonate, for a man's throat: means of published measurements, rounded.
constexpr std::array<std::array<double, 4>, kSynthVowels> kVowels_hz{{{750, 1200, 2550, 3500},
                                                                      {300, 2250, 2950, 3600},
                                                                      {350, 1300, 2350, 3400},
                                                                      {480, 1900, 2550, 3500},
                                                                      {480, 850, 2500, 3400}}};

// The part of the way that a value goes in one sample, for an exponential
// approach with this time constant.
double Share(double time_s) {
  return 1 - std::exp(-1 / (time_s * kSynthRate_hz));
}

}  // namespace

void VoiceSynth::Say(int vowel, double loudness) {
  vowel_ = std::clamp(vowel, 0, kSynthVowels - 1);
  loudness_ = std::isnan(loudness) ? 0 : std::clamp(loudness, 0.0, 4.0);
}

// The pitch runs on in silence, and so does the measure of how loud it is.
VoiceSynth::VoiceSynth() {
  for (int n = 0; n < kSynthRate_hz / 4; ++n) Next();
}

std::int16_t VoiceSynth::Next() {
  static const double attack = Share(kAttack_s), level = Share(kLevel_s);
  if (to_shape_-- <= 0) Shape();
  gain_ += attack * (loudness_ - gain_);
  const double voiced = Throat(Glottis());
  level_ += level * (voiced * voiced - level_);
  const double voice = kLoud * gain_ * voiced / std::sqrt(std::max(level_, kLeast));
  return static_cast<std::int16_t>(
      std::lround(32767 * std::clamp(voice + kVoiceSynthRoom * Noise(), -1.0, 1.0)));
}

// A throat that has been silent begins with its own vowel; a speaking one glides.
void VoiceSynth::Shape() {
  static const double glide = Share(kGlide_s / kShape);
  to_shape_ = kShape - 1;
  for (std::size_t n = 0; n < kFormants; ++n) {
    const double goal_hz = kVowels_hz[static_cast<std::size_t>(vowel_)][n];
    // The throat moves once in kShape samples, so its time is shorter by as much.
    formants_hz_[n] += (gain_ < 0.01 ? 1 : glide) * (goal_hz - formants_hz_[n]);
    // Bandwidths of some 60 to 200 Hz, growing with the frequency, as they are measured.
    const double width_hz = 50 + formants_hz_[n] * 0.04;
    const double radius = std::exp(-std::numbers::pi * width_hz / kSynthRate_hz);
    // A pole pair at radius r and angle 2 pi f / rate: b = 2 r cos(angle), c = -r^2.
    resonances_[n].b = 2 * radius * std::cos(2 * std::numbers::pi * formants_hz_[n] / kSynthRate_hz);
    resonances_[n].c = -radius * radius;
  }
}

double VoiceSynth::Glottis() {
  phase_ += kPitch_hz / kSynthRate_hz;
  double pulse = 0;
  if (phase_ >= 1) {
    phase_ -= 1;
    pulse = 1;
  }
  for (double& past : pulse_)
    pulse = past += (pulse - past) * (2 * std::numbers::pi * kGlottis_hz / kSynthRate_hz);
  return pulse;
}

// Resonances of two poles each, and what the lips radiate: the change.
double VoiceSynth::Throat(double pulse) {
  double now = pulse;
  for (Resonance& r : resonances_) {
    now = (1 - r.b - r.c) * now + r.b * r.past[0] + r.c * r.past[1];
    r.past = {now, r.past[0]};
  }
  const double change = now - radiated_;
  radiated_ = now;
  return change;
}

double VoiceSynth::Noise() {
  // A linear congruential generator (Numerical Recipes): its high bits are good enough for a hiss.
  random_ = random_ * 1664525U + 1013904223U;
  return static_cast<double>(random_ >> 8U) / (1U << 23U) - 1;
}

}  // namespace kaori::sim
