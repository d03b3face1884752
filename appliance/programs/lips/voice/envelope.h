// The resonances of a mouth, from a moment of its voice: linear prediction, and the peaks of its envelope.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace kaori::voice {

inline constexpr int kVoiceRate_hz = 12000;  // A quarter of the microphone's: vowels live below 4 kHz.
inline constexpr int kOrder = 12;            // One resonance for each kHz.
inline constexpr std::size_t kGrid = 180;    // Points of the envelope,
inline constexpr float kGridStep_hz = 20;    // so far apart, from 0 on.

// Predicts each sample from the kOrder before it; [0] is 1. None where there is nothing to predict.
using Prediction = std::array<float, kOrder + 1>;
std::optional<Prediction> Predict(std::span<const float> samples);

// Magnitude in dB at n * kGridStep_hz, of mean 0.
using Envelope = std::array<float, kGrid>;
Envelope EnvelopeOf(const Prediction& prediction);

}  // namespace kaori::voice
