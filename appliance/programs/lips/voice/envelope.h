// The spectral envelope of a moment of voice by linear prediction; its peaks are the resonances of the mouth.
// Twelve poles are enough for the four formants below 4 kHz and the fall of the voice, and too few to follow
// its pitch.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace kaori::voice {

inline constexpr int kVoiceRate_hz = 12000;  // A quarter of the microphone's rate: vowels lie below 4 kHz.
inline constexpr int kOrder = 12;            // The order of the predictor: about one resonance for each kHz.
inline constexpr std::size_t kGrid = 180;    // The envelope has so many points,
inline constexpr float kGridStep_hz = 20;    // at this distance from 0 Hz on.

// The predictor's coefficients, by Levinson and Durbin; [0] is 1. Nothing for silence. The samples are at
// kVoiceRate_hz, some 20 to 40 ms of them; borrowed. Pure, as all of this file.
using Prediction = std::array<float, kOrder + 1>;
std::optional<Prediction> Predict(std::span<const float> samples);

// The magnitude in dB at n * kGridStep_hz, with a mean of 0.
using Envelope = std::array<float, kGrid>;
// The envelope of a prediction; frequencies go from 0 to 3580 Hz.
Envelope EnvelopeOf(const Prediction& prediction);

}  // namespace kaori::voice
