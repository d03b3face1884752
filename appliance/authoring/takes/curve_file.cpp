#include "appliance/authoring/takes/curve_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace kaori::authoring {
namespace {

// Two numbers.
bool IsPair(const toml::Value& value) {
  const auto is_number = [](const toml::Value& v) { return v.kind == toml::Value::Kind::kNumber; };
  return value.kind == toml::Value::Kind::kList && value.list.size() == 2 &&
         std::ranges::all_of(value.list, is_number);
}

class CurveReader {
 public:
  CurveReader(toml::Faults& faults, const std::string& item, const CurveRules& rules)
      : faults_(faults), item_(item), rules_(rules) {}

  // A value that is no pair ends the curve; wrong numbers are told and reading goes on.
  std::vector<show::MotionKey> Read(const toml::Value& pairs) {
    for (const toml::Value& pair : pairs.list) {
      if (!IsPair(pair)) {
        Fault(pair, "a pair [second, value] is expected");
        return {};
      }
      ReadPair(pair, static_cast<float>(pair.list[0].number), static_cast<float>(pair.list[1].number));
    }
    if (keys_.size() < 2) {
      Fault(pairs, "must have two pairs or more");
      return {};
    }
    // A motion is added to what operators do: one that began or ended elsewhere would make the head jump.
    for (const toml::Value* end : {&pairs.list.front(), &pairs.list.back()})
      if (rules_.rests && end->list[1].number != 0)
        Fault(*end, "a curve must start and end at 0, so that nothing jumps");
    return std::move(keys_);
  }

 private:
  // Seconds rise from 0 to kLongestMotion_s.
  void ReadPair(const toml::Value& pair, float at_s, float written) {
    if (!(at_s >= 0 && at_s <= show::kLongestMotion_s))
      Fault(pair, fmt::format("second {} does not lie within 0 to {}", at_s, show::kLongestMotion_s));
    if (!keys_.empty() && !(at_s > keys_.back().at_s))
      Fault(pair, fmt::format("second {} must lie after second {}", at_s, keys_.back().at_s));
    const float unit = rules_.name != nullptr ? rules_.name->unit : 1;
    const std::string_view words = rules_.name != nullptr ? rules_.name->words : "";
    if (!(std::abs(written * unit) <= show::kWidestMotion))
      Fault(pair, words.empty() ? fmt::format("{} does not lie within {} to {}; 1 is the whole way", written,
                                              -show::kWidestMotion, show::kWidestMotion)
                                : fmt::format("{} {}, and {:.0f} to either side are the most", written, words,
                                              std::floor(show::kWidestMotion / unit)));
    keys_.push_back({at_s, written});
  }

  void Fault(const toml::Value& at, const std::string& reason) { faults_.Add(at.line, item_, reason); }

  toml::Faults& faults_;
  const std::string& item_;
  const CurveRules& rules_;
  std::vector<show::MotionKey> keys_;
};

}  // namespace

std::vector<show::MotionKey> ReadCurveKeys(toml::Faults& faults, const std::string& item,
                                           const toml::Value& pairs, const CurveRules& rules) {
  return CurveReader(faults, item, rules).Read(pairs);
}

}  // namespace kaori::authoring
