#include "appliance/show/check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "render/face/check.h"

namespace kaori::show {
namespace {

std::size_t Count(const Show& show, CallKind kind) {
  switch (kind) {
    case CallKind::kNothing: return 1;
    case CallKind::kFace: return show.cast.faces.size();
    case CallKind::kExpression: return show.cast.expressions.size();
    case CallKind::kStyle: return scene::kStyleCount;
    case CallKind::kScene: return show.scenes.size();
  }
  return 0;
}

void CheckButtons(const Show& show, std::vector<std::string>& faults) {
  for (std::size_t i = 0; i < show.buttons.size(); ++i)
    if (const Call& call = show.buttons[i]; call.index >= Count(show, call.kind))
      faults.push_back(fmt::format("button {}: calls number {} of {}", i + 1, call.index, Count(show, call.kind)));
}

void CheckTake(const Show& show, const Take& take, std::vector<std::string>& faults) {
  for (const TakeCurve& curve : take.curves) {
    if (curve.target > TakeTarget::kChannel || curve.channel >= show.cast.expressions.size())
      faults.push_back(fmt::format("take \"{}\": a curve moves nothing that exists", take.name));
    if (curve.keys.size() < 2 || curve.keys.front().value != 0 || curve.keys.back().value != 0)
      faults.push_back(fmt::format("take \"{}\": a curve must start and end at 0", take.name));
    if (!std::ranges::is_sorted(curve.keys, {}, &TakeKey::at_s))
      faults.push_back(fmt::format("take \"{}\": the times of a curve must rise", take.name));
    if (std::ranges::any_of(curve.keys, [](const TakeKey& k) { return !std::isfinite(k.at_s + k.value); }))
      faults.push_back(fmt::format("take \"{}\": a curve holds a value that is no number", take.name));
  }
}

void CheckScene(const Show& show, const StageScene& scene, std::vector<std::string>& faults) {
  if (scene.face >= show.cast.faces.size())
    faults.push_back(fmt::format("scene \"{}\": there is no face {}", scene.name, scene.face));
  if (scene.expression >= show.cast.expressions.size())
    faults.push_back(fmt::format("scene \"{}\": there is no expression {}", scene.name, scene.expression));
  if (static_cast<int>(scene.style) >= scene::kStyleCount)
    faults.push_back(fmt::format("scene \"{}\": there is no style {}", scene.name, static_cast<int>(scene.style)));
  if (!std::isfinite(scene.exposure + scene.fade_s) || scene.fade_s < 0)
    faults.push_back(fmt::format("scene \"{}\": its light or its fade is no sound number", scene.name));
}

void CheckChannels(const Show& show, std::vector<std::string>& faults) {
  const auto check = [&](const char* role, int index) {
    if (index >= static_cast<int>(show.cast.expressions.size()) || index < -1)
      faults.push_back(fmt::format("channel {}: there is no expression {}", role, index));
  };
  for (const int index : show.channels.brow_up) check("brow_up", index);
  for (const int index : show.channels.mouth) check("mouth", index);
  check("brow_frown", show.channels.brow_frown);
  check("lids_up", show.channels.lids_up);
  check("lids_down", show.channels.lids_down);
}

}  // namespace

std::vector<std::string> CheckShow(const Show& show) {
  std::vector<std::string> faults = face::FindFaults(show.cast);
  CheckButtons(show, faults);
  for (const Take& take : show.takes) CheckTake(show, take, faults);
  for (const StageScene& scene : show.scenes) CheckScene(show, scene, faults);
  CheckChannels(show, faults);
  return faults;
}

}  // namespace kaori::show
