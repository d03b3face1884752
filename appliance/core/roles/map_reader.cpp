#include "appliance/core/roles/map_reader.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/roles/named.h"

namespace kaori::roles {

using show::InfoOf;
using show::RoleMap;

// The control is read first: whether it turns decides between per_turn and range.
RoleMap MapReader::Read() {
  section_.AllowOnly({"control", "level", "range", "per_turn", "dead", "curve", "takeover"});
  ReadControl();
  if (const auto level = levels_.Read(section_)) {
    map_.level = *level;
    show::Turns(map_.control) ? ReadTurn() : ReadRange();
  }
  map_.dead = section_.FloatOr("dead", 0, 0, show::kMostDead);
  ReadCurve();
  if (section_.Has("takeover")) ReadTakeover();
  return std::move(map_);
}

// Where an overlay names no device the control's name alone is judged; LayOver has the
// whole role checked later.
void MapReader::ReadControl() {
  const std::string name = section_.Text("control");
  if (name.empty()) return;
  const auto control = show::ControlNamed(name);
  if (!control)
    return section_.Fault(
        "control", fmt::format("there is no control \"{}\"; controls are x, y, twist, hat x, hat y, slider "
                               "of a stick, and dial 1 to dial 8",
                               name));
  map_.control = control->control;
  map_.dial = control->dial;
  if (device_ && !show::Has(*device_, map_.control))
    section_.Fault("control", fmt::format("the {} has no {}",
                                          show::kDeviceNames[static_cast<std::size_t>(*device_)], name));
}

// Within the level's ends, in its own unit; both ends may be swapped.
void MapReader::ReadRange() {
  const show::LevelInfo& level = InfoOf(map_.level);
  map_.from = level.low;
  map_.to = level.high;
  if (section_.Has("per_turn")) section_.Fault("per_turn", "is for dials; a control with ends has a range");
  if (!section_.Has("range")) return;
  const std::vector<double> range = section_.Numbers("range");
  if (range.size() != 2 || range[0] == range[1])
    return section_.Fault("range", "must be two different numbers [at the one end, at the other]");
  map_.from = Inside("range", range[0]);
  map_.to = Inside("range", range[1]);
}

// A ten-thousandth of the range is forgiven, as rounded
// degrees need, and then cut off.
float MapReader::Inside(std::string_view key, double written) {
  const show::LevelInfo& level = InfoOf(map_.level);
  const double low = level.low / level.unit, high = level.high / level.unit, slack = (high - low) * 1e-4;
  if (!(written >= low - slack && written <= high + slack))
    section_.Fault(key, fmt::format("{} is not within {:.4g} to {:.4g}{}{} of {}", written, low, high,
                                    level.words.empty() ? "" : " ", level.words, level.name));
  return std::clamp(static_cast<float>(written * level.unit), level.low, level.high);
}

// One turn adds the whole range where nothing is said, and a hundred times that at most.
// Below 0 the dial is inverted.
void MapReader::ReadTurn() {
  const show::LevelInfo& level = InfoOf(map_.level);
  if (section_.Has("range")) section_.Fault("range", "is for controls with ends; a dial has per_turn");
  const float whole = (level.high - level.low) / level.unit;
  const float turn = section_.FloatOr("per_turn", whole, -100 * whole, 100 * whole);
  if (turn == 0) section_.Fault("per_turn", "is 0: the dial would do nothing");
  map_.to = turn * level.unit;
}

// A number is an exponent, a list holds points. A point that is no pair ends the list,
// since it cannot be one curve.
void MapReader::ReadCurve() {
  const toml::Value* curve = section_.Find("curve");
  if (curve == nullptr) return;
  if (curve->kind == toml::Value::Kind::kNumber) {
    map_.exponent = section_.FloatOr("curve", 1, show::kFlattestCurve, show::kSteepestCurve);
    return;
  }
  if (curve->kind != toml::Value::Kind::kList)
    return section_.Fault("curve", "must be an exponent, or points [[0, 0], [0.5, 0.3], [1, 1]]");
  for (const toml::Value& point : curve->list) {
    if (point.kind != toml::Value::Kind::kList || point.list.size() != 2 ||
        point.list[0].kind != toml::Value::Kind::kNumber || point.list[1].kind != toml::Value::Kind::kNumber)
      return section_.Fault("curve", "each of its points must be two numbers");
    map_.points.emplace_back(point.list[0].number, point.list[1].number);
  }
  if (!show::IsCurve(map_.points))
    section_.Fault("curve", fmt::format("must be 2 to {} points that rise from [0, 0] to [1, 1]",
                                        show::kMostCurvePoints));
}

// A spring always comes from its middle and a dial only turns: neither has a place from which it would
// leap.
void MapReader::ReadTakeover() {
  const auto takeover = IndexOf(section_, "takeover", section_.Text("takeover"), show::kTakeoverNames);
  if (takeover) map_.takeover = static_cast<show::Takeover>(*takeover);
  if (!show::StaysPut(map_.control))
    section_.Fault("takeover", "is for controls that stay where they are put: the slider of a stick");
}

}  // namespace kaori::roles
