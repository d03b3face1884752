#include "hw-sim/console/json.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace kaori::console {
namespace {

// Keeps the order in which it was written, so that equal states are equal texts.
using Json = nlohmann::ordered_json;

// Four digits are finer than the page draws, and equal states give equal text.
double Rounded(double value) {
  return std::round(value * 1e4) / 1e4;
}

// As the page draws them; hat and buttons are whole numbers.
Json StickJson(const sim::StickPod& stick) {
  return {{"x", Rounded(stick.x())},           {"y", Rounded(stick.y())}, {"twist", Rounded(stick.twist())},
          {"slider", Rounded(stick.slider())}, {"hat", stick.hat()},      {"buttons", stick.buttons_down()}};
}

Json PointerJson(const sim::Pointer& pointer) {
  return {{"x", Rounded(pointer.x())}, {"y", Rounded(pointer.y())}, {"buttons", pointer.buttons_down()}};
}

Json PortsJson(const sim::Rig& rig) {
  Json ports = Json::object();
  for (int port = 0; port < sim::kDevicePortCount; ++port) {
    const auto name = sim::PortName(static_cast<sim::DevicePort>(port));
    ports[std::string(name)] = {{"plugged", rig.plugged(name)}, {"connected", rig.connected(name)}};
  }
  return ports;
}

Json ValuesJson(const DialValues& values) {
  Json json = Json::array();
  for (int dial = 0; dial < kDialCount; ++dial) {
    // null, where the page is to show no number.
    const auto value = values.value(dial);
    json.push_back(value ? Json(Rounded(*value)) : Json());
  }
  return json;
}

Json OnStageJson(const std::optional<OnStage>& on_stage) {
  if (!on_stage) return {};
  const OnStage& now = *on_stage;
  return {{"scene", now.scene},     {"style", now.style},     {"cue", now.cue},
          {"standby", now.standby}, {"pending", now.pending}, {"left_s", std::ceil(now.left_s * 10) / 10},
          {"paused", now.paused},   {"black", now.black},     {"panicking", now.panicking},
          {"waiting", now.waiting}, {"refused", now.refused}};
}

}  // namespace

std::string StateJson(sim::Rig& rig, const DialValues& values, const EditorWatch& editor,
                      const std::optional<OnStage>& on_stage, double frames_per_s) {
  Json dials = Json::array();
  for (int dial = 0; dial < kDialCount; ++dial) dials.push_back(Rounded(rig.dial_box().turned(dial)));
  const auto mouth = rig.camera().mouth();
  return Json({{"dials", dials},
               {"values", ValuesJson(values)},
               {"buttons", rig.dial_box().buttons_down()},
               {"lamps", rig.dial_box().lamps()},
               {"sticks", {StickJson(rig.left_stick()), StickJson(rig.right_stick())}},
               {"lips", {{"height", Rounded(mouth.height)}, {"width", Rounded(mouth.width)}}},
               {"covered", rig.camera().covered()},
               {"voice",
                {{"vowel", rig.microphone().vowel()}, {"loudness", Rounded(rig.microphone().loudness())}}},
               {"loudspeaker_db", std::round(rig.loudspeaker().level_db())},
               {"pointer", PointerJson(rig.pointer())},
               {"editor_open", editor.open()},
               {"lines", {{"closed", rig.lines().closed()}, {"tally", rig.lines().tally()}}},
               {"on_stage", OnStageJson(on_stage)},
               {"ports", PortsJson(rig)},
               {"fps", std::round(frames_per_s)}})
      .dump();
}

}  // namespace kaori::console
