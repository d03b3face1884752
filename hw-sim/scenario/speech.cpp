#include "hw-sim/scenario/speech.h"

#include <algorithm>
#include <cctype>

#include "hw-sim/devices/lip_picture.h"

namespace kaori::sim {
namespace {

constexpr Mouth kAtRest{};

// What is said in an equal part of the time.
struct Syllable {
  bool shuts_first = false;  // m, b, p: the lips meet before it.
  // What the mouth looks like while the vowel is held.
  Mouth mouth;
  int vowel = 0;  // As Verb::kVoice numbers them.
  // As Verb::kVoice has it.
  double loudness = 1;
};

// Height and width in widths of the mouth at rest: a wide open, i spread, u and o rounded.
Mouth VowelMouth(char vowel) {
  switch (vowel) {
    case 'a':
      return {0.78, 1.02};
    case 'i':
      return {0.36, 1.20};
    case 'u':
      return {0.34, 0.64};
    case 'e':
      return {0.52, 1.10};
    default:
      return {0.60, 0.74};
  }
}

// Lips that meet, as for m, b and p.
constexpr Mouth kShut{0.22, 0.96};
// An n that ends a word is a faint u: the vowel with the narrowest mouth.
constexpr int kHummed = 2;
constexpr double kHum = 0.3;
constexpr std::string_view kLabials = "mbp";

// Parts of a syllable's time: until the lips have met, and until the mouth stands. The rest it is held.
constexpr double kShutPart = 0.22;
constexpr double kOpenPart = 0.62;

// A consonant counts with the vowel behind it; an n at the end of a word is a syllable of its own, as in
// Japanese.
std::vector<Syllable> Syllables(std::string_view text) {
  std::vector<Syllable> syllables;
  bool shuts = false;
  char before = ' ';
  // One step beyond the end stands for the space that ends the last word.
  for (std::size_t n = 0; n <= text.size(); ++n) {
    const char c =
        n < text.size() ? static_cast<char>(std::tolower(static_cast<unsigned char>(text[n]))) : ' ';
    if (kVowelLetters.find(c) != std::string_view::npos) {
      syllables.push_back({shuts, VowelMouth(c), static_cast<int>(kVowelLetters.find(c)), 1});
      shuts = false;
    } else if (c == ' ') {
      if (before == 'n') syllables.push_back({false, kShut, kHummed, kHum});
      shuts = false;
    } else {
      // Any labial before the vowel shuts the lips, as in "mya".
      shuts |= kLabials.find(c) != std::string_view::npos;
    }
    before = c;
  }
  return syllables;
}

TimedAction Shape(Duration at, Duration over, const Mouth& mouth) {
  return {at, over, {DevicePort::kCamera, Verb::kLips, 0, mouth.height, mouth.width}};
}

TimedAction Sound(Duration at, int vowel, double loudness) {
  return {at, {}, {DevicePort::kMicrophone, Verb::kVoice, vowel, loudness, 0}};
}

}  // namespace

bool CanSay(std::string_view text) {
  const auto sayable = [](char c) { return c == ' ' || std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return std::ranges::all_of(text, sayable) && !Syllables(text).empty();
}

// Each syllable: the lips meet where it begins with a labial, then open to the vowel's shape,
// and are held for the rest of its part.
std::vector<TimedAction> Speak(std::string_view text, Duration at, Duration over) {
  const auto syllables = Syllables(text);
  // The way back to rest takes as long as half a syllable.
  const auto part = over / static_cast<double>(static_cast<double>(syllables.size()) + 0.5);
  const auto after = [&](double parts) { return at + std::chrono::duration_cast<Duration>(part * parts); };
  std::vector<TimedAction> actions;
  for (std::size_t n = 0; n < syllables.size(); ++n) {
    const auto start = static_cast<double>(n);
    double open = start;
    if (syllables[n].shuts_first) {
      open += kShutPart;
      actions.push_back(Shape(after(start), after(open) - after(start), kShut));
      // Lips that are shut let no voice out.
      actions.push_back(Sound(after(start), syllables[n].vowel, 0));
    }
    actions.push_back(Shape(after(open), after(start + kOpenPart) - after(open), syllables[n].mouth));
    actions.push_back(Sound(after(open), syllables[n].vowel, syllables[n].loudness));
  }
  const Duration end = after(static_cast<double>(syllables.size()));
  actions.push_back(Shape(end, at + over - end, kAtRest));
  actions.push_back(Sound(end, syllables.back().vowel, 0));
  return actions;
}

}  // namespace kaori::sim
