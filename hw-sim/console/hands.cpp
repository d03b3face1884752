#include "hw-sim/console/hands.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace kaori::console {
namespace {

using sim::Hand;
using sim::Place;
using sim::Verb;

constexpr double kMostTurns = 4;  // In one line: more than a wrist does between two of the page's messages.

// The words of one line, taken one by one; the first thing that is wrong stays.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string_view Next() {
    const auto begin = rest_.find_first_not_of(' ');
    if (begin == std::string_view::npos) return rest_ = {};
    const auto end = std::min(rest_.find(' ', begin), rest_.size());
    const auto word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }

  double Number(std::string_view what, double least, double most) {
    const auto word = Next();
    double value = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = fault == std::errc{} && end == word.data() + word.size();
    // A NaN fails both comparisons.
    if (whole && value >= least && value <= most) return value;
    Refuse(fmt::format("{} is '{}': it goes from {} to {}", what, word, least, most));
    return least;
  }

  int Index(std::string_view what, int first, int last) {
    const double value = Number(what, first, last);
    if (value != std::floor(value)) Refuse(fmt::format("{} is {}: it is a whole number", what, value));
    return static_cast<int>(value);
  }

  // True for `yes`, false for `no`.
  bool Choose(std::string_view yes, std::string_view no) {
    const auto word = Next();
    if (word != yes && word != no) Refuse(fmt::format("'{}' is neither {} nor {}", word, yes, no));
    return word == yes;
  }

  void Refuse(std::string why) {
    if (!fault_) fault_ = std::move(why);
  }

  std::optional<std::string> Finish() {
    if (const auto extra = Next(); !extra.empty()) Refuse(fmt::format("'{}' is one word too many", extra));
    return fault_;
  }

 private:
  std::string_view rest_;
  std::optional<std::string> fault_;
};

Hand ParseDial(Words& words) {
  const int dial = words.Index("the dial", 1, 8) - 1;
  if (words.Next() != "turn") words.Refuse("a dial can only turn");
  return {Place::kDialBox, Verb::kTurn, dial, words.Number("the turn", -kMostTurns, kMostTurns)};
}

Hand ParseButton(Words& words) {
  const int button = words.Index("the button", 1, 32) - 1;
  return {Place::kDialBox, words.Choose("push", "release") ? Verb::kPush : Verb::kRelease, button};
}

Hand ParseHat(Words& words, Place place) {
  Words ahead = words;
  if (ahead.Next() != "centre") return {place, Verb::kHat, words.Index("the hat", 0, 7)};
  words = ahead;
  return {place, Verb::kHat, -1};
}

Hand ParseMove(Words& words, Place place) {
  const double x = words.Number("x", -1, 1);
  return {place, Verb::kMove, 0, x, words.Number("y", -1, 1)};
}

Hand ParseStick(Words& words) {
  const Place place = words.Choose("left", "right") ? Place::kStickLeft : Place::kStickRight;
  const auto verb = words.Next();
  if (verb == "move") return ParseMove(words, place);
  if (verb == "twist") return {place, Verb::kTwist, 0, words.Number("the twist", -1, 1)};
  if (verb == "slide") return {place, Verb::kSlide, 0, words.Number("the slider", 0, 1)};
  if (verb == "hat") return ParseHat(words, place);
  if (verb == "push") return {place, Verb::kPush, words.Index("the stick's button", 1, 12) - 1};
  if (verb == "release") return {place, Verb::kRelease, words.Index("the stick's button", 1, 12) - 1};
  words.Refuse(fmt::format("a stick cannot '{}': move, twist, slide, hat, push, release", verb));
  return {};
}

Hand ParseKey(Words& words) {
  const int usage = words.Index("the key's usage", 4, 231);
  return {Place::kKeyboard, words.Choose("press", "release") ? Verb::kPush : Verb::kRelease, usage};
}

Hand ParseLips(Words& words) {
  const double height = words.Number("the lips' height", 0, 2);
  return {Place::kCamera, Verb::kLips, 0, height, words.Number("the lips' width", 0, 2)};
}

Hand ParseLens(Words& words) {
  return {Place::kCamera, Verb::kCoverLens, words.Choose("cover", "open") ? 1 : 0};
}

Hand ParseCable(Words& words) {
  const auto port = words.Next();
  const auto place = sim::PlaceNamed(port);
  if (!place) words.Refuse(fmt::format("no device is called '{}'", port));
  return {place.value_or(Place::kDialBox), words.Choose("plug", "pull") ? Verb::kPlug : Verb::kUnplug};
}

struct Noun {
  std::string_view name;
  Hand (*parse)(Words&);
};
constexpr Noun kNouns[] = {{"dial", ParseDial},  {"button", ParseButton}, {"stick", ParseStick},
                           {"key", ParseKey},    {"lips", ParseLips},     {"lens", ParseLens},
                           {"cable", ParseCable}};

Result<Hand> ParseLine(std::string_view line) {
  Words words(line);
  const auto name = words.Next();
  for (const Noun& noun : kNouns) {
    if (noun.name != name) continue;
    Hand hand = noun.parse(words);
    if (auto fault = words.Finish()) return FailInput(std::move(*fault));
    return hand;
  }
  return FailInput(
      fmt::format("'{}' is no part of the console: dial, button, stick, key, lips, lens, cable", name));
}

}  // namespace

Result<std::vector<sim::Hand>> ParseHands(std::string_view text) {
  std::vector<Hand> hands;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    const auto line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.find_first_not_of(' ') == std::string_view::npos) continue;
    auto hand = ParseLine(line);
    if (!hand) return FailInput(fmt::format("line {}: {}", number, hand.error().attempt));
    hands.push_back(std::move(*hand));
  }
  return hands;
}

}  // namespace kaori::console
