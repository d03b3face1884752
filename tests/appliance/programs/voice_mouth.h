// A voice made by rule: a glottis that pulses, a throat that resonates, lips that radiate, and noise.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace kaori::tests {

struct Spoken {
  std::array<double, 4> formants_hz;
  double pitch_hz = 120;
  double throat = 1;       // Its resonances lie this much higher.
  double noise_db = -200;  // Of the voice.
  double rate_hz = 48000;
  unsigned seed = 1;
};

// One resonance (two poles), in place.
inline void Resonate(std::vector<double>& sound, double formant_hz, double width_hz, double rate_hz) {
  const double radius = std::exp(-std::numbers::pi * width_hz / rate_hz);
  const double b = 2 * radius * std::cos(2 * std::numbers::pi * formant_hz / rate_hz), c = -radius * radius;
  double one = 0, two = 0;
  for (double& sample : sound) {
    const double now = (1 - b - c) * sample + b * one + c * two;
    two = one;
    one = now;
    sample = now;
  }
}

inline double Rms(const std::vector<double>& sound) {
  double sum = 0;
  for (const double sample : sound) sum += sample * sample;
  return std::sqrt(sum / static_cast<double>(sound.size()));
}

// `seconds` of a held vowel, its RMS 0.1 of full scale.
inline std::vector<float> Speak(const Spoken& spoken, double seconds) {
  std::vector<double> sound(static_cast<std::size_t>(seconds * spoken.rate_hz));
  std::mt19937 random(spoken.seed);
  std::normal_distribution<double> normal;
  double phase = 0;
  for (double& sample : sound) {
    phase += spoken.pitch_hz / spoken.rate_hz;
    sample = phase >= 1 ? 1 : 0;
    phase -= phase >= 1 ? 1 : 0;
  }
  for (int pole = 0; pole < 2; ++pole) {  // A glottal pulse falls by 12 dB an octave.
    double past = 0;
    for (double& sample : sound)
      sample = past += (sample - past) * (2 * std::numbers::pi * 100 / spoken.rate_hz);
  }
  for (const double formant_hz : spoken.formants_hz)
    Resonate(sound, formant_hz * spoken.throat, 50 + formant_hz * 0.04, spoken.rate_hz);
  double before = 0;
  for (double& sample : sound) {  // Lips radiate what changes.
    const double now = sample;
    sample = now - before;
    before = now;
  }
  const double rms = Rms(sound), noise = std::pow(10, spoken.noise_db / 20);
  std::vector<float> out;
  for (const double sample : sound)
    out.push_back(static_cast<float>(0.1 * (sample / rms + noise * normal(random))));
  return out;
}

}  // namespace kaori::tests
