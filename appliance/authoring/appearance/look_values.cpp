#include "appliance/authoring/appearance/look_values.h"

#include <string>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/core/toml/nearest.h"

namespace kaori::appearance {

using toml::Section;
using toml::Value;

float Real(Section& s, std::string_view key) {
  return static_cast<float>(s.Number(key));
}

float RealOr(Section& s, std::string_view key, float otherwise) {
  return static_cast<float>(s.NumberOr(key, otherwise));
}

// Numbers that are not finite never come here: the reader of TOML refuses them.
float Share(Section& s, std::string_view key, float otherwise) {
  const float value = RealOr(s, key, otherwise);
  if (!(value >= 0 && value <= 1)) s.Fault(key, "must lie between 0 and 1");
  return value;
}

// Without an upper bound; a caller that needs one says so in a fault of its own.
float NotNegative(Section& s, std::string_view key, float otherwise) {
  const float value = RealOr(s, key, otherwise);
  if (value < 0) s.Fault(key, "must not be negative");
  return value;
}

// "#rrggbb" as linear RGB; a fault, and black, where it is anything else.
glm::vec3 Colour(Section& s, std::string_view key) {
  const auto colour = ColourFromHex(s.Text(key));
  if (!colour) s.Fault(key, "must be a colour such as \"#f2cbb3\"");
  return colour.value_or(glm::vec3(0));
}

namespace {

bool IsPair(const Value& v) {
  return v.kind == Value::Kind::kList && v.list.size() == 2 && v.list[0].kind == Value::Kind::kNumber &&
         v.list[1].kind == Value::Kind::kNumber;
}

}  // namespace

// The words of the fault tell a key that is missing from one of another form.
glm::vec2 Pair(Section& s, std::string_view key) {
  const Value* value = s.Find(key);
  if (value != nullptr && IsPair(*value)) return {value->list[0].number, value->list[1].number};
  s.Fault(key, value == nullptr ? "is missing" : "must be two numbers [x, y]");
  return {};
}

// A pair that is none is left out, after its fault.
std::vector<glm::vec2> Positions(Section& s, std::string_view key) {
  std::vector<glm::vec2> positions;
  const Value* value = s.Find(key);
  if (value == nullptr) s.Fault(key, "is missing");
  if (value == nullptr) return positions;
  for (const Value& pair : value->list)
    if (IsPair(pair))
      positions.emplace_back(pair.list[0].number, pair.list[1].number);
    else
      s.Fault(key, "must be a list of pairs [x, y]");
  return positions;
}

// An empty table after a fault of form; Table() answers 0 for it.
Knots Pairs(Section& s, std::string_view key) {
  Knots knots;
  const Value* value = s.Find(key);
  if (value == nullptr) {
    s.Fault(key, "is missing");
    return knots;
  }
  for (const Value& pair : value->list) {
    if (!IsPair(pair)) {
      s.Fault(key, "must be a list of pairs of numbers");
      return {};
    }
    knots.emplace_back(static_cast<float>(pair.list[0].number), static_cast<float>(pair.list[1].number));
    const bool rises = knots.size() < 2 || knots.back().x > knots[knots.size() - 2].x;
    if (!rises) s.Fault(key, "the first number of each pair must rise");
  }
  if (knots.size() < 2) s.Fault(key, "must have two pairs or more");
  return knots;
}

Knots PairsOrNone(Section& s, std::string_view key) {
  return s.Has(key) ? Pairs(s, key) : Knots{};
}

// The fault lists all words, and says which may have been meant.
std::size_t OneOf(Section& s, std::string_view key, std::span<const std::string_view> words) {
  const std::string word = s.Text(key);
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (word == words[i]) return i;
    list += (i == 0 ? "\"" : ", \"") + std::string(words[i]) + "\"";
  }
  s.Fault(key, "must be one of " + list + toml::DidYouMean(word, {words.begin(), words.end()}));
  return 0;
}

}  // namespace kaori::appearance
