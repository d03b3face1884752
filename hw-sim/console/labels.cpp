#include "hw-sim/console/labels.h"

#include <algorithm>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "drivers/base/read_file.h"

namespace kaori::console {
namespace {

using Json = nlohmann::ordered_json;

// Usages of real keys: below are error codes, above there are none (HID Usage Tables 1.3, page 7).
constexpr std::uint64_t kFirstUsage = 0x04;
constexpr std::uint64_t kLastUsage = 0xE7;
// Far more keys than a show explains; they bound what a wrong file makes the page draw.
constexpr std::size_t kMostKeys = 64;
constexpr std::size_t kMostCues = 2000;  // As a show may have.
constexpr std::size_t kMostLevels = 64;
constexpr std::size_t kMostMotions = 4096;  // As a show may have.

// An entry that is left out is empty; one of another kind is not, and fails the whole file.
bool ReadText(const Json& json, const char* name, std::string& into) {
  if (!json.is_object() || !json.contains(name)) return json.is_object();
  if (!json[name].is_string()) return false;
  into = json[name].get<std::string>();
  return true;
}

// A number that is left out keeps its default.
bool ReadNumber(const Json& json, const char* name, double& into) {
  if (!json.contains(name)) return true;
  if (!json[name].is_number()) return false;
  into = json[name].get<double>();
  return true;
}

// False: what is there is no list of texts. A list that is missing leaves `into` as it was.
bool ReadTexts(const Json& json, const char* name, std::vector<std::string>& into) {
  if (!json.contains(name)) return true;
  if (!json[name].is_array()) return false;
  for (const Json& text : json[name]) {
    if (!text.is_string()) return false;
    into.push_back(text.get<std::string>());
  }
  return true;
}

// The short form: a text alone.
bool ReadTextAlone(const Json& json, std::string& into) {
  if (json.is_string()) into = json.get<std::string>();
  return json.is_string();
}

// A text alone stands for a dial of that name; its other fields keep their defaults.
bool ReadDial(const Json& json, DialLabel& into) {
  if (ReadTextAlone(json, into.text)) return true;
  return ReadText(json, "text", into.text) && ReadText(json, "unit", into.unit) &&
         ReadNumber(json, "low", into.low) && ReadNumber(json, "high", into.high) &&
         ReadNumber(json, "per_turn", into.per_turn) && ReadNumber(json, "start", into.start) &&
         ReadTexts(json, "filled_by", into.filled_by);
}

bool ReadButton(const Json& json, ButtonLabel& into) {
  return ReadText(json, "text", into.text) && ReadText(json, "group", into.group);
}

// The array `name` of `json`, entry by entry into `into`; nothing, or the entry that is wrong.
template <class Row, class Read>
std::optional<std::string> ReadRow(const Json& json, const char* name, Row& into, Read read) {
  if (!json.contains(name)) return std::nullopt;
  const Json& row = json[name];
  if (!row.is_array() || row.size() > into.size()) return fmt::format("{} are {} at most", name, into.size());
  for (std::size_t n = 0; n < row.size(); ++n)
    if (!read(row[n], into[n])) return fmt::format("{}, entry {}", name, n + 1);
  return std::nullopt;
}

bool ReadStick(const Json& json, StickLabel& into) {
  if (ReadTextAlone(json, into.text)) return true;
  return ReadText(json, "text", into.text) && ReadText(json, "twist", into.twist) &&
         ReadText(json, "slide", into.slide) && !ReadRow(json, "buttons", into.buttons, ReadButton);
}

// The usage is needed; the rest may be left out.
bool ReadKey(const Json& json, KeyLabel& into) {
  if (!json.is_object() || !json.contains("usage") || !json["usage"].is_number_unsigned()) return false;
  const auto usage = json["usage"].get<std::uint64_t>();
  into.usage = static_cast<std::uint8_t>(usage);
  return usage >= kFirstUsage && usage <= kLastUsage && ReadText(json, "text", into.text) &&
         ReadText(json, "group", into.group);
}

bool ReadCue(const Json& json, CueLabel& into) {
  if (!json.is_object()) return false;
  const bool by_itself = json.contains("by_itself");
  if (by_itself && !json["by_itself"].is_boolean()) return false;
  into.by_itself = by_itself && json["by_itself"].get<bool>();
  return ReadText(json, "number", into.number) && ReadText(json, "text", into.text) &&
         ReadText(json, "act", into.act) && ReadText(json, "notes", into.notes);
}

bool ReadLevel(const Json& json, LevelLabel& into) {
  return json.is_object() && ReadText(json, "text", into.text) && ReadText(json, "unit", into.unit) &&
         ReadNumber(json, "per_unit", into.per_unit) && ReadNumber(json, "low", into.low) &&
         ReadNumber(json, "high", into.high) && ReadNumber(json, "rest", into.rest);
}

// What is left out is false.
bool ReadFlag(const Json& json, const char* name, bool& into) {
  if (!json.contains(name)) return true;
  if (!json[name].is_boolean()) return false;
  into = json[name].get<bool>();
  return true;
}

bool ReadMotion(const Json& json, MotionLabel& into) {
  return json.is_object() && ReadText(json, "text", into.text) && ReadText(json, "moves", into.moves) &&
         ReadNumber(json, "length_s", into.length_s) && ReadFlag(json, "loops", into.loops) &&
         ReadFlag(json, "take", into.take) && ReadFlag(json, "sound", into.sound);
}

// The entry that is wrong, for people; nothing: all is well.
std::optional<std::string> ReadLabels(const Json& json, Labels& into) {
  if (!json.is_object()) return "no JSON object";
  if (!ReadText(json, "show", into.show)) return "show";
  if (!ReadTexts(json, "scenes", into.scenes)) return "scenes";
  if (!ReadTexts(json, "styles", into.styles)) return "styles";
  if (!ReadTexts(json, "roles", into.roles)) return "roles";
  if (!ReadTexts(json, "devices", into.devices)) return "devices";
  if (!ReadTexts(json, "teachable", into.teachable)) return "teachable";
  // Rows have a fixed length, but the keys: as many as the file has, or one row of the most.
  if (json.contains("keys")) into.keys.assign(std::min(json["keys"].size(), kMostKeys), {});
  if (json.contains("cues")) into.cues.assign(std::min(json["cues"].size(), kMostCues), {});
  if (json.contains("levels")) into.levels.assign(std::min(json["levels"].size(), kMostLevels), {});
  if (json.contains("motions")) into.motions.assign(std::min(json["motions"].size(), kMostMotions), {});
  if (auto fault = ReadRow(json, "motions", into.motions, ReadMotion)) return fault;
  if (auto fault = ReadRow(json, "cues", into.cues, ReadCue)) return fault;
  if (auto fault = ReadRow(json, "levels", into.levels, ReadLevel)) return fault;
  if (auto fault = ReadRow(json, "dials", into.dials, ReadDial)) return fault;
  if (auto fault = ReadRow(json, "buttons", into.buttons, ReadButton)) return fault;
  if (auto fault = ReadRow(json, "second_buttons", into.second_buttons, ReadButton)) return fault;
  if (auto fault = ReadRow(json, "sticks", into.sticks, ReadStick)) return fault;
  return ReadRow(json, "keys", into.keys, ReadKey);
}

Json ButtonsJson(std::span<const ButtonLabel> buttons) {
  Json json = Json::array();
  for (const auto& button : buttons) json.push_back({{"text", button.text}, {"group", button.group}});
  return json;
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
  // Without exceptions: a text that is no JSON gives a discarded value, which is no object.
  if (auto fault = ReadLabels(Json::parse(*text, nullptr, false), labels))
    return FailInput(fmt::format("labels {}: {}", path, *fault));
  return labels;
}

std::string LabelsJson(const Labels& labels) {
  Json json{{"show", labels.show},     {"dials", Json::array()},    {"buttons", Json::array()},
            {"sticks", Json::array()}, {"scenes", labels.scenes},   {"styles", labels.styles},
            {"keys", Json::array()},   {"cues", Json::array()},     {"levels", Json::array()},
            {"roles", labels.roles},   {"devices", labels.devices}, {"teachable", labels.teachable},
            {"motions", Json::array()}};
  for (const auto& dial : labels.dials) json["dials"].push_back(DialJson(dial));
  json["buttons"] = ButtonsJson(labels.buttons);
  json["second_buttons"] = ButtonsJson(labels.second_buttons);
  for (const auto& stick : labels.sticks)
    json["sticks"].push_back({{"text", stick.text},
                              {"twist", stick.twist},
                              {"slide", stick.slide},
                              {"buttons", ButtonsJson(stick.buttons)}});
  for (const auto& key : labels.keys)
    json["keys"].push_back({{"usage", key.usage}, {"text", key.text}, {"group", key.group}});
  for (const auto& cue : labels.cues)
    json["cues"].push_back({{"number", cue.number},
                            {"text", cue.text},
                            {"act", cue.act},
                            {"notes", cue.notes},
                            {"by_itself", cue.by_itself}});
  for (const auto& level : labels.levels)
    json["levels"].push_back({{"text", level.text},
                              {"unit", level.unit},
                              {"per_unit", level.per_unit},
                              {"low", level.low},
                              {"high", level.high},
                              {"rest", level.rest}});
  for (const auto& motion : labels.motions)
    json["motions"].push_back({{"text", motion.text},
                               {"moves", motion.moves},
                               {"length_s", motion.length_s},
                               {"loops", motion.loops},
                               {"take", motion.take},
                               {"sound", motion.sound}});
  // Text that is not UTF-8 is shown with replacement signs: a label never stops the page.
  return json.dump(-1, ' ', false, nlohmann::detail::error_handler_t::replace);
}

}  // namespace kaori::console
