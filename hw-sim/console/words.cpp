#include "hw-sim/console/words.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace kaori::console {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

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
