#include "hw-sim/console/labels.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "drivers/base/read_file.h"

namespace kaori::console {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kFirstUsage = 0x04;
constexpr std::uint64_t kLastUsage = 0xE7;
constexpr std::size_t kMostKeys = 64;

// An entry that is left out is empty; one of another kind is not.
bool TakeText(const Json& json, const char* name, std::string& into) {
  if (!json.is_object() || !json.contains(name)) return json.is_object();
  if (!json[name].is_string()) return false;
  into = json[name].get<std::string>();
  return true;
}

bool TakeNumber(const Json& json, const char* name, double& into) {
  if (!json.contains(name)) return true;
  if (!json[name].is_number()) return false;
  into = json[name].get<double>();
  return true;
}

bool TakeTexts(const Json& json, const char* name, std::vector<std::string>& into) {
  if (!json.contains(name)) return true;
  if (!json[name].is_array()) return false;
  for (const Json& text : json[name]) {
    if (!text.is_string()) return false;
    into.push_back(text.get<std::string>());
  }
  return true;
}

// The short form: a text alone.
bool TakeTextAlone(const Json& json, std::string& into) {
  if (json.is_string()) into = json.get<std::string>();
  return json.is_string();
}

bool TakeDial(const Json& json, DialLabel& into) {
  if (TakeTextAlone(json, into.text)) return true;
  return TakeText(json, "text", into.text) && TakeText(json, "unit", into.unit) &&
         TakeNumber(json, "low", into.low) && TakeNumber(json, "high", into.high) &&
         TakeNumber(json, "per_turn", into.per_turn) && TakeNumber(json, "start", into.start) &&
         TakeTexts(json, "filled_by", into.filled_by);
}

bool TakeStick(const Json& json, StickLabel& into) {
  if (TakeTextAlone(json, into.text)) return true;
  return TakeText(json, "text", into.text) && TakeText(json, "twist", into.twist) &&
         TakeText(json, "slide", into.slide);
}

bool MotionKey(const Json& json, KeyLabel& into) {
  if (!json.is_object() || !json.contains("usage") || !json["usage"].is_number_unsigned()) return false;
  const auto usage = json["usage"].get<std::uint64_t>();
  into.usage = static_cast<std::uint8_t>(usage);
  return usage >= kFirstUsage && usage <= kLastUsage && TakeText(json, "text", into.text) &&
         TakeText(json, "group", into.group);
}

bool TakeButton(const Json& json, ButtonLabel& into) {
  return TakeText(json, "text", into.text) && TakeText(json, "group", into.group);
}

// The array `name` of `json`, entry by entry into `into`; nothing, or the entry that is wrong.
template <class Row, class Take>
std::optional<std::string> TakeRow(const Json& json, const char* name, Row& into, Take take) {
  if (!json.contains(name)) return std::nullopt;
  const Json& row = json[name];
  if (!row.is_array() || row.size() > into.size()) return fmt::format("{} are {} at most", name, into.size());
  for (std::size_t n = 0; n < row.size(); ++n)
    if (!take(row[n], into[n])) return fmt::format("{}, entry {}", name, n + 1);
  return std::nullopt;
}

std::optional<std::string> TakeLabels(const Json& json, Labels& into) {
  if (!json.is_object()) return "no JSON object";
  if (!TakeText(json, "show", into.show)) return "show";
  if (json.contains("keys")) into.keys.assign(std::min(json["keys"].size(), kMostKeys), {});
  if (auto fault = TakeRow(json, "dials", into.dials, TakeDial)) return fault;
  if (auto fault = TakeRow(json, "buttons", into.buttons, TakeButton)) return fault;
  if (auto fault = TakeRow(json, "sticks", into.sticks, TakeStick)) return fault;
  return TakeRow(json, "keys", into.keys, MotionKey);
}

Json DialJson(const DialLabel& dial) {
  return {{"text", dial.text},          {"unit", dial.unit},         {"low", dial.low},
          {"high", dial.high},          {"per_turn", dial.per_turn}, {"start", dial.start},
          {"filled_by", dial.filled_by}};
}

}  // namespace

Result<Labels> LoadLabels(const std::string& path) {
  const auto text = ReadFile(path, {.most_levels = kMostLevels});
  if (!text) return tl::unexpected(text.error());
  Labels labels;
  if (auto fault = TakeLabels(Json::parse(*text, nullptr, false), labels))
    return FailInput(fmt::format("labels {}: {}", path, *fault));
  return labels;
}

std::string LabelsJson(const Labels& labels) {
  Json json{{"show", labels.show},
            {"dials", Json::array()},
            {"buttons", Json::array()},
            {"sticks", Json::array()},
            {"keys", Json::array()}};
  for (const auto& dial : labels.dials) json["dials"].push_back(DialJson(dial));
  for (const auto& button : labels.buttons)
    json["buttons"].push_back({{"text", button.text}, {"group", button.group}});
  for (const auto& stick : labels.sticks)
    json["sticks"].push_back({{"text", stick.text}, {"twist", stick.twist}, {"slide", stick.slide}});
  for (const auto& key : labels.keys)
    json["keys"].push_back({{"usage", key.usage}, {"text", key.text}, {"group", key.group}});
  // Text that is not UTF-8 is shown with replacement signs: a label never stops the page.
  return json.dump(-1, ' ', false, nlohmann::detail::error_handler_t::replace);
}

}  // namespace kaori::console
