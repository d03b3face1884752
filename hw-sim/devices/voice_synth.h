// A voice by rule: a glottis that pulses, a throat whose resonances make the vowel, lips that
// radiate (the source-filter model of speech).
#pragma once

#include <array>
#include <cstdint>

namespace kaori::sim {

// Samples in a second.
inline constexpr int kSynthRate_hz = 48000;
inline constexpr int kSynthVowels = 5;  // a, i, u, e, o.

// Makes sound for whatever follows a voice: the formants are where a lip reader by ear looks for them.
// Sample by sample; the same orders give the same samples. Loudness and vowel change within a few
// milliseconds, without a click. One thread.
class VoiceSynth {
 public:
  VoiceSynth();

  // What is said from now on. `vowel` is held within 0 .. 4. `loudness` 0 is silence, 1 a voice of 0.1
  // of full scale (RMS); held within 0 .. 4.
  void Say(int vowel, double loudness);
  int vowel() const { return vowel_; }
  double loudness() const { return loudness_; }

  // The next sample, at kSynthRate_hz.
  std::int16_t Next();

 private:
  // Resonances of the throat; those above matter little to a vowel.
  static constexpr std::size_t kFormants = 4;
  // Moves the formants on towards the vowel, and makes the resonances from them.
  void Shape();
  // The next sample of the glottis: a pulse in each period of the pitch, through a low pass of two poles.
  double Glottis();
  // The next sample behind the resonances and the lips.
  double Throat(double pulse);
  // From -1 to 1, evenly spread.
  double Noise();

  // What is said, as Say held it within its range.
  int vowel_ = 0;
  // 0 is silence, 1 as one speaks.
  double loudness_ = 0;
  double gain_ = 0;   // On its way to the loudness.
  double phase_ = 0;  // Of the pitch, in turns.
  // The two poles of the glottis' low pass.
  std::array<double, 2> pulse_{};
  // Where the resonances are now, on their way to the vowel's.
  std::array<double, kFormants> formants_hz_{750, 1200, 2550, 3500};
  // y = (1 - b - c) x + b y[-1] + c y[-2]: gain 1 at 0 Hz.
  struct Resonance {
    // Two poles, as the formant has them now, and the last two outputs.
    double b = 0, c = 0;
    std::array<double, 2> past{};
  };
  std::array<Resonance, kFormants> resonances_;
  int to_shape_ = 0;  // Samples until the throat moves on.
  // The throat's last output, whose change is what the lips radiate.
  double radiated_ = 0;
  double level_ = 1e-4;  // Mean square of the voice before its gain: every vowel is as loud.
  // The state of the noise; its beginning is as good as any other.
  std::uint32_t random_ = 1993;
};

}  // namespace kaori::sim
