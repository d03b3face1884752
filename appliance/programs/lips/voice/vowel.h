// Which of A, I, U, E, O a moment of voice is, and how the mouth looks that says it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "appliance/programs/lips/voice/envelope.h"

namespace kaori::voice {

enum class Vowel : unsigned char { kA, kI, kU, kE, kO };
inline constexpr std::size_t kVowelCount = 5;

// The mouth's height and width, each from 0 (shut, narrow) to 1 (open, wide) of what this operator's does.
struct MouthShare {
  float height = 0;
  float width = 0.5F;
};

struct VowelGuess {
  Vowel likeliest = Vowel::kA;
  std::array<float, kVowelCount> likely{};  // Of sum 1.
  MouthShare mouth;                         // Of all five, each as far as it is likely.
};

// Of a moment of 20 to 40 ms at kVoiceRate_hz. None where there is no sound. Allocates nothing.
std::optional<VowelGuess> GuessVowel(std::span<const float> samples);

}  // namespace kaori::voice
