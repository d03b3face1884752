// Which of A, I, U, E, O a moment of voice is, and the mouth that says it. The spectral envelope of the
// moment is compared with those of five vowels in throats of four lengths, as linear prediction would give
// them. That is good enough for a mouth, which needs to be plausible in every frame and not right in each.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "appliance/programs/lips/voice/envelope.h"

namespace kaori::voice {

// The five vowels of Japanese, in its order.
enum class Vowel : unsigned char { kA, kI, kU, kE, kO };
inline constexpr std::size_t kVowelCount = 5;

// The mouth's height and width, each from 0 (shut, narrow) to 1 (open, wide) of this operator's range.
struct MouthShare {
  float height = 0;
  float width = 0.5F;
};

struct VowelGuess {
  Vowel likeliest = Vowel::kA;
  std::array<float, kVowelCount> likely{};  // The likelihoods, whose sum is 1.
  MouthShare mouth;                         // The mean of the five mouths, weighted by likelihood.
};

// Compares a moment of 20 to 40 ms at kVoiceRate_hz with templates. Nothing for silence. Allocates nothing
// after its first call. The samples are mono, -1 .. 1, and borrowed for the call. Any thread.
std::optional<VowelGuess> GuessVowel(std::span<const float> samples);

}  // namespace kaori::voice
