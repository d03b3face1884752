#include "appliance/core/show/check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "appliance/core/show/check_cues.h"
#include "render/face/check.h"

namespace kaori::show {
namespace {

using Faults = std::vector<std::string>;

// False for NaN too: every comparison with it is.
bool Within(float value, float low, float high) {
  return value >= low && value <= high;
}

// How many things a call of this kind chooses from; 0 for a number that is no kind, so that every index of it
// is a fault.
std::size_t Count(const Show& show, CallKind kind) {
  switch (kind) {
    case CallKind::kNothing:
      return 1;
    case CallKind::kFace:
      return show.cast.faces.size();
    case CallKind::kExpression:
      return show.cast.expressions.size();
    case CallKind::kStyle:
      return scene::kStyleCount;
    case CallKind::kScene:
      return show.scenes.size();
    case CallKind::kCue:
      return kCueVerbCount;
    case CallKind::kSheet:
      return kSheetCount;
    case CallKind::kMotion:
      return show.motions.size();
    case CallKind::kBlink:
      return kBlinkNames.size();
    case CallKind::kGoTo:
      return show.cue_list.cues.size();
  }
  return 0;
}

// Indices of 16 bits stand in calls, terms and files; kMostItems keeps them there with room for the
// expressions that the editor appends.
void CheckCounts(const Show& show, Faults& faults) {
  const auto check = [&](const char* items, std::size_t count) {
    if (count > kMostItems)
      faults.push_back(fmt::format("{}: {}, and {} at most can be played", items, count, kMostItems));
  };
  check("faces", show.cast.faces.size());
  check("expressions", show.cast.expressions.size());
  check("props", show.cast.props.size());
  check("textures", show.cast.textures.size());
  check("keys", show.keys.size());
  check("motions", show.motions.size());
  check("scenes", show.scenes.size());
  if (show.cast.textures.empty()) faults.emplace_back("textures: there is none, and every face wants one");
}

void CheckCall(const Show& show, const std::string& item, const Call& call, Faults& faults) {
  if (call.index >= Count(show, call.kind))
    faults.push_back(fmt::format("{}: calls number {} of {}", item, call.index, Count(show, call.kind)));
  if (call.mode > CallMode::kMomentary || (call.mode != CallMode::kCall && !Joins(call.kind)))
    faults.push_back(item + ": only faces, expressions and sheets are toggles or momentary");
}

// Buttons are counted from 1 in faults, as people count those of a box.
void CheckButtons(const Show& show, Faults& faults) {
  for (std::size_t i = 0; i < show.buttons.size(); ++i) {
    CheckCall(show, fmt::format("button {}", i + 1), show.buttons[i], faults);
    CheckCall(show, fmt::format("button {} of the second sheet", i + 1), show.second_buttons[i], faults);
  }
  for (std::size_t i = 0; i < show.stick_buttons.size(); ++i)
    CheckCall(
        show,
        fmt::format("button {} of the {}", i % kStickButtonCount + 1, kDeviceNames[i / kStickButtonCount]),
        show.stick_buttons[i], faults);
}

// Roles may name them; a show whose roles name none has none.
void CheckMixes(const Show& show, Faults& faults) {
  for (const Call& mix : show.roles.mixes)
    if (mix.kind == CallKind::kSheet || !Joins(mix.kind) || mix.index >= Count(show, mix.kind))
      faults.emplace_back("roles: a level is of a face or an expression that the show has not");
}

// A time below 0 is none of its own; NaN is no time.
void CheckFades(const char* items, const std::vector<ItemFade>& fades, std::size_t count, Faults& faults) {
  if (fades.size() > count) faults.push_back(fmt::format("fades: there are more than {}", items));
  const auto wrong = [](const ItemFade& fade) {
    return !(fade.in_s <= kLongestItemFade_s && fade.out_s <= kLongestItemFade_s) ||
           std::isnan(fade.in_s + fade.out_s) || fade.curve > FadeCurve::kSlowEnd;
  };
  if (std::ranges::any_of(fades, wrong))
    faults.push_back(fmt::format("fades: one of {} is longer than {} s, or none", items, kLongestItemFade_s));
}

void CheckKey(const std::string& item, std::uint16_t usage, Faults& faults) {
  if (usage >= kKeyUsages) faults.push_back(fmt::format("{}: there is no key {}", item, usage));
}

// Keys are named by their HID usage in faults: a pack does not know what is printed on them.
void CheckKeyCall(const Show& show, const KeyCall& key, Faults& faults) {
  const std::string item = fmt::format("key {}", key.key_usage);
  CheckKey(item, key.key_usage, faults);
  CheckCall(show, item, key.call, faults);
}

// The player looks for keys by binary search and divides by their distance, so that times must rise; it adds
// curves without a fade, so that they must begin and end at 0; the end of a loop is not played.
void CheckCurve(const Show& show, const Motion& motion, const MotionCurve& curve, Faults& faults) {
  const std::string item = fmt::format("motion \"{}\"", motion.name);
  if (static_cast<std::uint8_t>(curve.target) >= kMotionTargetCount ||
      curve.channel >= show.cast.expressions.size())
    faults.push_back(item + ": a curve moves nothing that exists");
  const auto ends = [&motion](const MotionKey& last) {
    return last.value == 0 || (motion.Loops() && last.at_s > motion.loop_to_s);
  };
  if (curve.keys.size() < 2 || curve.keys.front().value != 0 || !ends(curve.keys.back()))
    faults.push_back(item + ": a curve must start and end at 0");
  const auto steady = [](const MotionKey& a, const MotionKey& b) { return !(b.at_s > a.at_s); };
  if (std::ranges::adjacent_find(curve.keys, steady) != curve.keys.end())
    faults.push_back(item + ": the times of a curve must rise");
  const auto far = [](const MotionKey& k) {
    return !Within(k.at_s, 0, kLongestMotion_s) || !Within(k.value, -kWidestMotion, kWidestMotion);
  };
  if (std::ranges::any_of(curve.keys, far))
    faults.push_back(fmt::format("{}: a curve leaves 0 to {} s, or -{} to {}", item, kLongestMotion_s,
                                 kWidestMotion, kWidestMotion));
}

// The player mixes whole frames at 48 kHz; other rates were converted when the show was packed.
void CheckSound(const std::string& item, const Sound& sound, Faults& faults) {
  if (sound.channels < 1 || sound.channels > 2)
    return faults.push_back(fmt::format("{}: a sound of {} channels", item, sound.channels));
  const auto channels = static_cast<std::size_t>(sound.channels);
  if (sound.samples.size() % channels != 0) faults.push_back(item + ": its sound ends within a frame");
  const std::size_t frames = sound.samples.size() / channels;
  if (static_cast<float>(frames) > kLongestMotion_s * static_cast<float>(kSoundRate_hz))
    faults.push_back(fmt::format("{}: its sound is longer than {} s", item, kLongestMotion_s));
}

// From its end a loop goes on at its beginning, so that every curve must be at the same place there. The
// least is so small that nobody sees it: 0.06 degrees.
void CheckLoop(const std::string& item, const Motion& motion, Faults& faults) {
  constexpr float kUnseenJump = 1e-3F;
  if (motion.loop_from_s == 0 && motion.loop_to_s == 0) return;
  if (!Within(motion.loop_from_s, 0, kLongestMotion_s) || !Within(motion.loop_to_s, 0, kLongestMotion_s) ||
      motion.loop_to_s - motion.loop_from_s < kShortestLoop_s)
    return faults.push_back(fmt::format("{}: its loop from {} to {} s is none of {} s or more", item,
                                        motion.loop_from_s, motion.loop_to_s, kShortestLoop_s));
  if (!motion.sound.samples.empty()) faults.push_back(item + ": a motion with a sound cannot loop");
  const auto at = [&motion](const MotionCurve& curve, float at_s) {
    return ValueAt(curve.keys, motion.recorded, at_s);
  };
  for (const MotionCurve& curve : motion.curves)
    if (!(std::abs(at(curve, motion.loop_to_s) - at(curve, motion.loop_from_s)) <= kUnseenJump))
      faults.push_back(item + ": its loop jumps from its end to its beginning");
}

void CheckMotion(const Show& show, const Motion& motion, Faults& faults) {
  const std::string item = fmt::format("motion \"{}\"", motion.name);
  CheckKey(item, motion.key_usage, faults);
  if (motion.layer > MotionLayer::kOver) faults.push_back(item + ": its layer is not known");
  for (const MotionCurve& curve : motion.curves) CheckCurve(show, motion, curve, faults);
  CheckLoop(item, motion, faults);
  CheckSound(item, motion.sound, faults);
}

// Linear or not, a colour has three parts within 0..1.
bool IsColour(const glm::vec3& c) {
  return Within(c.x, 0, 1) && Within(c.y, 0, 1) && Within(c.z, 0, 1);
}

void CheckBackdrop(const Show& show, const std::string& item, const scene::Backdrop& backdrop,
                   Faults& faults) {
  if (!IsColour(backdrop.top) || !IsColour(backdrop.bottom) || !IsColour(backdrop.glow))
    faults.push_back(item + ": its backdrop holds a colour that is none");
  const int kind = static_cast<int>(backdrop.kind);
  if (kind >= scene::kBackdropKindCount)
    faults.push_back(fmt::format("{}: there is no kind of backdrop {}", item, kind));
  const bool picture = backdrop.kind == scene::BackdropKind::kPicture;
  if (picture && (backdrop.picture < 0 || backdrop.picture >= static_cast<int>(show.cast.textures.size())))
    faults.push_back(fmt::format("{}: there is no picture {}", item, backdrop.picture));
}

// Each number of a scene becomes an index or a factor somewhere, and comes from a file:
// none is used before this.
void CheckScene(const Show& show, const StageScene& scene, Faults& faults) {
  const std::string item = fmt::format("scene \"{}\"", scene.name);
  CheckKey(item, scene.key_usage, faults);
  if (scene.face >= show.cast.faces.size())
    faults.push_back(fmt::format("{}: there is no face {}", item, scene.face));
  if (scene.expression >= show.cast.expressions.size())
    faults.push_back(fmt::format("{}: there is no expression {}", item, scene.expression));
  if (static_cast<int>(scene.style) >= scene::kStyleCount)
    faults.push_back(fmt::format("{}: there is no style {}", item, static_cast<int>(scene.style)));
  if (!Within(scene.exposure, 0, kMostExposure))
    faults.push_back(
        fmt::format("{}: its light is {}, not within 0 to {}", item, scene.exposure, kMostExposure));
  if (!Within(scene.fade_s, 0, kLongestFade_s))
    faults.push_back(
        fmt::format("{}: its fade is {} s, not within 0 to {}", item, scene.fade_s, kLongestFade_s));
  CheckBackdrop(show, item, scene.backdrop, faults);
  for (const float amount : scene.life)
    if (!Within(amount, 0, kMostLife))
      faults.push_back(fmt::format("{}: its life is {}, not within 0 to {}", item, amount, kMostLife));
  if (scene.gaze < kNoTarget || scene.gaze >= static_cast<std::int32_t>(show.gaze_targets.size()))
    faults.push_back(fmt::format("{}: there is no gaze target {}", item, scene.gaze));
}

// A target behind her, or between her eyes, would turn them out of her head.
void CheckTargets(const Show& show, Faults& faults) {
  const auto& targets = show.gaze_targets;
  if (targets.size() > kMostGazeTargets)
    faults.push_back(
        fmt::format("gaze: {} targets, and {} at most can be played", targets.size(), kMostGazeTargets));
  if (!targets.empty() && targets.front().name != kHouseName)
    faults.emplace_back("gaze: the first target is not the house");
  for (const GazeTarget& target : targets)
    if (!IsTarget(target.at_m))
      faults.push_back(fmt::format("gaze \"{}\": is not {} to {} m before her", target.name, kNearestTarget_m,
                                   kFarthestTarget_m));
}

// -1 is a role that no expression plays. That is no fault: nothing moves then.
void CheckChannels(const Show& show, Faults& faults) {
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

// The cast's faults come first, then those of the show in the order of its parts.
std::vector<std::string> CheckShow(const Show& show) {
  Faults faults = face::FindFaults(show.cast);
  CheckCounts(show, faults);
  CheckButtons(show, faults);
  CheckFades("faces", show.face_fades, show.cast.faces.size(), faults);
  CheckFades("expressions", show.expression_fades, show.cast.expressions.size(), faults);
  CheckMixes(show, faults);
  for (const KeyCall& key : show.keys) CheckKeyCall(show, key, faults);
  for (const Motion& motion : show.motions) CheckMotion(show, motion, faults);
  for (const StageScene& scene : show.scenes) CheckScene(show, scene, faults);
  CheckChannels(show, faults);
  CheckTargets(show, faults);
  CheckCueList(show, faults);
  CheckRoles(show.roles, faults);
  CheckLobby(show, faults);
  return faults;
}

}  // namespace kaori::show
