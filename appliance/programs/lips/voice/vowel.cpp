#include "appliance/programs/lips/voice/vowel.h"

#include <algorithm>
#include <cmath>

namespace kaori::voice {
namespace {

constexpr std::size_t kLow = 10, kHigh = 165;  // 200 Hz to 3.3 kHz, between the pitch and the noise.
// Per dB^2 of mean difference: a vowel that fits worse by 5 dB (RMS) has a seventh of the likelihood.
constexpr float kSharpness = 0.08F;
constexpr float kDepth_db = 36;  // How much of the envelope below its peak is compared.
constexpr std::array kThroats = {0.9F, 1.0F, 1.1F,
                                 1.2F};  // Factors on the formants; a shorter throat sounds higher.

// The formants of Japanese vowels for a man's throat: rounded means of published measurements. One vowel:
// four formants, and the mouth with which it is spoken (MouthShare).
struct Model {
  std::array<float, 4> formants_hz;
  MouthShare mouth;
};
constexpr std::array<Model, kVowelCount> kModels{{{{750, 1200, 2550, 3500}, {1.0F, 0.55F}},
                                                  {{300, 2250, 2950, 3600}, {0.2F, 0.95F}},
                                                  {{350, 1300, 2350, 3400}, {0.2F, 0.3F}},
                                                  {{480, 1900, 2550, 3500}, {0.5F, 0.75F}},
                                                  {{480, 850, 2500, 3400}, {0.6F, 0.15F}}}};

// The gain of a resonance in dB at `f_hz`; 0 dB at 0 Hz. A two-pole resonance whose bandwidth is 60 Hz and a
// twentieth of its frequency, as measured bandwidths of vowels are about.
float Resonance_db(float f_hz, float formant_hz) {
  const float width_hz = 60 + formant_hz * 0.05F;
  const float square = formant_hz * formant_hz;
  const float away = square - f_hz * f_hz;
  const float damped = f_hz * width_hz;
  return 10 * std::log10(square * square / (away * away + damped * damped));
}

// Raises what lies far below the peak, which is noise.
void Flood(Envelope& envelope) {
  const float loudest = *std::max_element(envelope.begin() + kLow, envelope.begin() + kHigh);
  for (float& value : envelope) value = std::max(value, loudest - kDepth_db);
}

// The envelope that linear prediction gives for a vowel.
Envelope Expected(const Model& model, float throat) {
  Envelope envelope{};
  for (std::size_t point = 0; point < kGrid; ++point) {
    const float f_hz = static_cast<float>(point) * kGridStep_hz;
    for (const float formant_hz : model.formants_hz)
      envelope[point] += Resonance_db(f_hz, formant_hz * throat);
  }
  Flood(envelope);
  return envelope;
}

// The envelope that a vowel has in one of the throats.
struct Template {
  std::size_t vowel;
  Envelope envelope;
};
using Templates = std::array<Template, kVowelCount * kThroats.size()>;

// Made at the first call, by one thread or several (C++ makes them wait): 20 envelopes of 180 points.
const Templates& AllTemplates() {
  static const Templates templates = [] {
    Templates made{};
    for (std::size_t n = 0; n < made.size(); ++n)
      made[n] = {n % kVowelCount, Expected(kModels[n % kVowelCount], kThroats[n / kVowelCount])};
    return made;
  }();
  return templates;
}

// The mean square of the difference without its mean and its tilt, since voices fall differently towards high
// frequencies. It is the residual of a straight line fitted to the difference over points that lie around 0:
// squares - sum^2 / n - tilt^2 / (n (n^2 - 1) / 12), over n.
float Difference(const Envelope& a, const Envelope& b) {
  constexpr auto kCount = static_cast<float>(kHigh - kLow);
  constexpr float kMiddle = (kCount - 1) / 2;
  float sum = 0, tilt = 0, squares = 0;
  for (std::size_t n = kLow; n < kHigh; ++n) {
    const float difference = a[n] - b[n];
    sum += difference;
    tilt += difference * (static_cast<float>(n - kLow) - kMiddle);
    squares += difference * difference;
  }
  const float tilts = kCount * (kCount * kCount - 1) / 12;
  return (squares - sum * sum / kCount - tilt * tilt / tilts) / kCount;
}

// A softmax of the differences. The mouth is the mean over all vowels, so that it does not leap where two are
// as likely.
VowelGuess Weigh(const std::array<float, kVowelCount>& differences) {
  VowelGuess guess;
  const float least = *std::ranges::min_element(differences);
  float all = 0;
  for (std::size_t n = 0; n < kVowelCount; ++n) {
    guess.likely[n] = std::exp(-kSharpness * (differences[n] - least));
    all += guess.likely[n];
  }
  guess.mouth = {0, 0};
  for (std::size_t n = 0; n < kVowelCount; ++n) {
    guess.likely[n] /= all;
    guess.mouth.height += guess.likely[n] * kModels[n].mouth.height;
    guess.mouth.width += guess.likely[n] * kModels[n].mouth.width;
  }
  guess.likeliest = static_cast<Vowel>(std::ranges::max_element(guess.likely) - guess.likely.begin());
  return guess;
}

}  // namespace

// The best throat counts for each vowel, since it is not known whose voice it is.
std::optional<VowelGuess> GuessVowel(std::span<const float> samples) {
  const auto prediction = Predict(samples);
  if (!prediction) return std::nullopt;
  Envelope envelope = EnvelopeOf(*prediction);
  Flood(envelope);
  std::array<float, kVowelCount> differences{};
  differences.fill(1e9F);
  for (const Template& expected : AllTemplates())
    differences[expected.vowel] =
        std::min(differences[expected.vowel], Difference(envelope, expected.envelope));
  return Weigh(differences);
}

}  // namespace kaori::voice
