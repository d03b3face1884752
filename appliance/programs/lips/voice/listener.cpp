#include "appliance/programs/lips/voice/listener.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kaori::voice {
namespace {

constexpr int kDecimation = 4;              // 48 kHz to 12 kHz.
constexpr float kCutOff = 5200 / 48000.0F;  // In parts of the rate; vowels pass.
constexpr std::size_t kLevelSamples = 120;  // The level is that of the newest 10 ms.
constexpr float kFullScale = 32768;

// A low pass: a sinc under a Hann window, with a sum of 1. Symmetric, so that it delays all frequencies
// alike: by 32 samples, 0.7 ms.
template <std::size_t kTaps>
std::array<float, kTaps> MakeLowPass() {
  std::array<float, kTaps> taps{};
  float sum = 0;
  for (std::size_t n = 0; n < kTaps; ++n) {
    const float x = static_cast<float>(n) - static_cast<float>(kTaps - 1) / 2;
    const float angle = 2 * std::numbers::pi_v<float> * kCutOff * x;
    const float window = 0.5F + 0.5F * std::cos(2 * std::numbers::pi_v<float> * x / (kTaps + 1));
    taps[n] = window * (x == 0 ? 1 : std::sin(angle) / angle);
    sum += taps[n];
  }
  for (float& tap : taps) tap /= sum;
  return taps;
}

}  // namespace

// The level is taken from the decimated sound, so that hiss above the voice opens no gate.
const Voice& Listener::Hear(const ports::SoundBlock& block, const ports::SoundFormat& format) {
  const auto channels = static_cast<std::size_t>(format.channels);
  if (block.xrun) moment_.fill(0);
  for (std::size_t n = 0; n + channels <= block.samples.size(); n += channels) {
    float sum = 0;
    for (std::size_t channel = 0; channel < channels; ++channel) sum += block.samples[n + channel];
    AddSample(sum / (kFullScale * static_cast<float>(channels)));
  }
  const auto frames = static_cast<long>(block.samples.size() / channels);
  const Duration length(frames * 1'000'000'000L / format.rate_hz);
  voice_.at = block.at + length;
  voice_.speaking = gate_.Accept(Level_db(std::span(moment_).last(kLevelSamples)), voice_.at, length);
  voice_.level_db = gate_.level_db();
  voice_.vowel = voice_.speaking ? GuessVowel(moment_) : std::nullopt;
  return voice_;
}

// Filters only every fourth time: the other results would be thrown away.
void Listener::AddSample(float sample) {
  std::shift_left(recent_.begin(), recent_.end(), 1);
  recent_.back() = sample;
  if (++phase_ < kDecimation) return;
  phase_ = 0;
  std::shift_left(moment_.begin(), moment_.end(), 1);
  moment_.back() = LowPassed();
}

// Symmetric taps: their order does not matter.
float Listener::LowPassed() const {
  static const std::array<float, kTaps> taps = MakeLowPass<kTaps>();
  float sum = 0;
  for (std::size_t n = 0; n < kTaps; ++n) sum += taps[n] * recent_[n];
  return sum;
}

}  // namespace kaori::voice
