#include "hw-sim/console/json.h"

#include <cmath>
#include <utility>

namespace kaori::console {
namespace {

using json::List;
using json::Object;

// Four digits are finer than the page draws, and equal states give equal text.
double Rounded(double value) {
  return std::round(value * 1e4) / 1e4;
}

// As the page draws them; hat and buttons are whole numbers.
Object StickJson(const sim::StickPod& stick) {
  return {{"x", Rounded(stick.x())},           {"y", Rounded(stick.y())}, {"twist", Rounded(stick.twist())},
          {"slider", Rounded(stick.slider())}, {"hat", stick.hat()},      {"buttons", stick.buttons_down()}};
}

Object PointerJson(const sim::Pointer& pointer) {
  return {{"x", Rounded(pointer.x())}, {"y", Rounded(pointer.y())}, {"buttons", pointer.buttons_down()}};
}

// Plugged: its cable is in. Connected: a program of the box has it open.
Object PortsJson(const sim::Rig& rig) {
  Object ports;
  for (int port = 0; port < sim::kDevicePortCount; ++port) {
    const auto name = sim::PortName(static_cast<sim::DevicePort>(port));
    ports.emplace_back(name, Object{{"plugged", rig.plugged(name)}, {"connected", rig.connected(name)}});
  }
  return ports;
}

List ValuesJson(const DialValues& values) {
  List list;
  for (int dial = 0; dial < kDialCount; ++dial) {
    json::Value& shown = list.emplace_back();  // null, where the page is to show no number.
    if (const auto value = values.value(dial)) shown = Rounded(*value);
  }
  return list;
}

}  // namespace

std::string StateJson(sim::Rig& rig, const DialValues& values, const EditorWatch& editor,
                      json::Value on_stage, double frames_per_s) {
  List dials;
  for (int dial = 0; dial < kDialCount; ++dial) dials.emplace_back(Rounded(rig.dial_box().turned(dial)));
  const auto mouth = rig.camera().mouth();
  return json::Write(Object{
      {"dials", std::move(dials)},
      {"values", ValuesJson(values)},
      {"buttons", rig.dial_box().buttons_down()},
      {"lamps", rig.dial_box().lamps()},
      {"sticks", List{StickJson(rig.left_stick()), StickJson(rig.right_stick())}},
      {"lips", Object{{"height", Rounded(mouth.height)}, {"width", Rounded(mouth.width)}}},
      {"covered", rig.camera().covered()},
      {"voice",
       Object{{"vowel", rig.microphone().vowel()}, {"loudness", Rounded(rig.microphone().loudness())}}},
      {"loudspeaker_db", std::round(rig.loudspeaker().level_db())},
      {"pointer", PointerJson(rig.pointer())},
      {"editor_open", editor.open()},
      {"lines", Object{{"closed", rig.lines().closed()}, {"tally", rig.lines().tally()}}},
      {"on_stage", std::move(on_stage)},
      {"ports", PortsJson(rig)},
      {"fps", std::round(frames_per_s)}});
}

}  // namespace kaori::console
