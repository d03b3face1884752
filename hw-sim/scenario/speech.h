// What a mouth does while it says syllables.
#pragma once

#include <string_view>
#include <vector>

#include "hw-sim/scenario/scenario.h"

namespace kaori::sim {

// The vowels of Verb::kVoice, by its number, in the order of Japanese.
inline constexpr std::string_view kVowelLetters = "aiueo";

// Whether Speak can say it: letters and spaces, with a vowel or an n at least. Pure.
bool CanSay(std::string_view text);

// Movements of the lips and of the voice from `at` on; the last of them brings the lips back to rest,
// `over` after the beginning. The voice sounds from the moment at which the lips begin to open. Every
// syllable (a vowel with what comes before it, or an n that ends a word) gets an equal part of the
// time. `text` must be one that CanSay. Pure.
std::vector<TimedAction> Speak(std::string_view text, Duration at, Duration over);

}  // namespace kaori::sim
