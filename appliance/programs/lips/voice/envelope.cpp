#include "appliance/programs/lips/voice/envelope.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace kaori::voice {
namespace {

// A voice falls by about 6 dB for each octave above its pitch; the difference to 0.9 of the sample before
// compensates most of that, so that the predictor spends its order on resonances.
constexpr double kPreEmphasis = 0.9;
constexpr double kNoiseFloor = 1e-4;  // Of the power; it keeps the recursion well conditioned.

using Correlation = std::array<double, kOrder + 1>;

// The autocorrelation of the samples under a Hann window, which hides where the moment was cut out.
Correlation Correlate(std::span<const float> samples) {
  Correlation sums{};
  std::array<double, kOrder + 1> past{};  // The newest first.
  const auto count = static_cast<double>(samples.size());
  for (std::size_t n = 1; n < samples.size(); ++n) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(n) / count;
    const double emphasised =
        static_cast<double>(samples[n]) - kPreEmphasis * static_cast<double>(samples[n - 1]);
    std::shift_right(past.begin(), past.end(), 1);
    past[0] = emphasised * (0.5 - 0.5 * std::cos(turn));
    for (std::size_t lag = 0; lag < sums.size(); ++lag) sums[lag] += past[0] * past[lag];
  }
  sums[0] *= 1 + kNoiseFloor;
  return sums;
}

}  // namespace

// The recursion of Levinson and Durbin. Durbin 1960: in each order the reflection coefficient is what the
// predictor so far leaves unexplained, over its error. The error stays positive by the noise floor, so that
// the filter is stable.
std::optional<Prediction> Predict(std::span<const float> samples) {
  const Correlation r = Correlate(samples);
  if (!std::isfinite(r[0]) || r[0] < 1e-12) return std::nullopt;
  std::array<double, kOrder + 1> a{1};
  double error = r[0];
  for (std::size_t order = 1; order <= kOrder; ++order) {
    double sum = r[order];
    for (std::size_t n = 1; n < order; ++n) sum += a[n] * r[order - n];
    const double reflection = -sum / error;
    const auto before = a;
    for (std::size_t n = 1; n < order; ++n) a[n] = before[n] + reflection * before[order - n];
    a[order] = reflection;
    error *= 1 - reflection * reflection;
  }
  Prediction prediction{};
  for (std::size_t n = 0; n <= kOrder; ++n) prediction[n] = static_cast<float>(a[n]);
  return prediction;
}

// 1 / |A(z)|^2 on the unit circle, by Horner's rule from the highest coefficient down. The mean is taken off,
// since loudness says nothing about the vowel.
Envelope EnvelopeOf(const Prediction& prediction) {
  Envelope envelope{};
  for (std::size_t point = 0; point < kGrid; ++point) {
    const double angle = -2 * std::numbers::pi * static_cast<double>(point) *
                         static_cast<double>(kGridStep_hz) / kVoiceRate_hz;
    const std::complex<double> step = std::polar(1.0, angle);
    std::complex<double> sum = 0;
    for (std::size_t n = kOrder + 1; n-- > 0;) sum = sum * step + static_cast<double>(prediction[n]);
    envelope[point] = static_cast<float>(-10 * std::log10(std::norm(sum) + 1e-12));
  }
  const float mean = std::accumulate(envelope.begin(), envelope.end(), 0.0F) / static_cast<float>(kGrid);
  for (float& value : envelope) value -= mean;
  return envelope;
}

}  // namespace kaori::voice
