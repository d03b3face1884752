#include "hw-sim/console/json.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace kaori::console {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kFirstUsage = 0x04;
constexpr std::uint64_t kLastUsage = 0xE7;
constexpr std::size_t kMostKeys = 64;

// Text that is not UTF-8 is shown with replacement signs: a label never stops the page.
std::string Dump(const Json& json) {
  return json.dump(-1, ' ', false, nlohmann::detail::error_handler_t::replace);
}

// Four digits are finer than the page draws, and equal states give equal text.
double Rounded(double value) {
  return std::round(value * 1e4) / 1e4;
}

Json StickJson(const sim::StickPod& stick) {
  return {{"x", Rounded(stick.x())},           {"y", Rounded(stick.y())}, {"twist", Rounded(stick.twist())},
          {"slider", Rounded(stick.slider())}, {"hat", stick.hat()},      {"buttons", stick.buttons_down()}};
}

Json PortsJson(const sim::Rig& rig) {
  Json ports = Json::object();
  for (int place = 0; place < sim::kPlaceCount; ++place) {
    const auto name = sim::PortName(static_cast<sim::Place>(place));
    ports[std::string(name)] = {{"plugged", rig.plugged(name)}, {"connected", rig.connected(name)}};
  }
  return ports;
}

// An entry that is left out is empty; one of another kind is not.
bool TakeText(const Json& json, const char* name, std::string& into) {
  if (!json.is_object() || !json.contains(name)) return json.is_object();
  if (!json[name].is_string()) return false;
  into = json[name].get<std::string>();
  return true;
}

bool TakeKey(const Json& json, KeyLabel& into) {
  if (!json.is_object() || !json.contains("usage") || !json["usage"].is_number_unsigned()) return false;
  const auto usage = json["usage"].get<std::uint64_t>();
  into.usage = static_cast<std::uint8_t>(usage);
  return usage >= kFirstUsage && usage <= kLastUsage && TakeText(json, "text", into.text) &&
         TakeText(json, "group", into.group);
}

bool TakeButton(const Json& json, ButtonLabel& into) {
  return TakeText(json, "text", into.text) && TakeText(json, "group", into.group);
}

bool TakeName(const Json& json, std::string& into) {
  if (json.is_string()) into = json.get<std::string>();
  return json.is_string();
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
  if (json.contains("keys")) into.keys.assign(std::min(json["keys"].size(), kMostKeys), {});
  if (auto fault = TakeRow(json, "dials", into.dials, TakeName)) return fault;
  if (auto fault = TakeRow(json, "buttons", into.buttons, TakeButton)) return fault;
  if (auto fault = TakeRow(json, "sticks", into.sticks, TakeName)) return fault;
  return TakeRow(json, "keys", into.keys, TakeKey);
}

}  // namespace

Result<Labels> LoadLabels(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return FailErrno("open labels " + path);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  Labels labels;
  if (auto fault = TakeLabels(Json::parse(text, nullptr, false), labels))
    return FailInput(fmt::format("labels {}: {}", path, *fault));
  return labels;
}

std::string LabelsJson(const Labels& labels) {
  Json json{{"dials", labels.dials},
            {"buttons", Json::array()},
            {"sticks", labels.sticks},
            {"keys", Json::array()}};
  for (const auto& button : labels.buttons)
    json["buttons"].push_back({{"text", button.text}, {"group", button.group}});
  for (const auto& key : labels.keys)
    json["keys"].push_back({{"usage", key.usage}, {"text", key.text}, {"group", key.group}});
  return Dump(json);
}

std::string StateJson(sim::Rig& rig, double frames_per_s) {
  Json dials = Json::array();
  for (int dial = 0; dial < 8; ++dial) dials.push_back(Rounded(rig.dial_box().turned(dial)));
  const auto mouth = rig.camera().mouth();
  return Dump({{"dials", dials},
               {"buttons", rig.dial_box().buttons_down()},
               {"lamps", rig.dial_box().lamps()},
               {"sticks", {StickJson(rig.left_stick()), StickJson(rig.right_stick())}},
               {"lips", {{"height", Rounded(mouth.height)}, {"width", Rounded(mouth.width)}}},
               {"covered", rig.camera().covered()},
               {"ports", PortsJson(rig)},
               {"fps", std::round(frames_per_s)}});
}

}  // namespace kaori::console
