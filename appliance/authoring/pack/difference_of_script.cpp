#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "appliance/authoring/pack/difference_parts.h"
#include "appliance/authoring/script/backdrop_file.h"
#include "appliance/core/roles/roles_file.h"
#include "appliance/core/show/cue_names.h"
#include "render/scene/scene.h"

namespace kaori::authoring {
namespace {

// "nothing" for a number that no item has, so that two packs can be compared whatever they hold.
template <class Items>
std::string NameOf(const Items& items, std::size_t index) {
  return index < items.size() ? items[index].name : "nothing";
}

std::string StyleName(std::size_t style) {
  return style < scene::kStyleNames.size() ? scene::kStyleNames[style] : "nothing";
}

// "face dog": what a button or key calls, in the same words as in show.toml. Names are compared, not numbers:
// a face that stands elsewhere in its list plays alike.
std::string Calls(const show::Show& show, const show::Call& call) {
  switch (call.kind) {
    case show::CallKind::kNothing:
      return "nothing";
    case show::CallKind::kFace:
      return "face " + NameOf(show.cast.faces, call.index);
    case show::CallKind::kExpression:
      return "expression " + NameOf(show.cast.expressions, call.index);
    case show::CallKind::kStyle:
      return "style " + StyleName(call.index);
    case show::CallKind::kScene:
      return "scene " + NameOf(show.scenes, call.index);
    case show::CallKind::kCue:
      return fmt::format(
          "cue {}", call.index < show::kCueVerbNames.size() ? show::kCueVerbNames[call.index] : "nothing");
    case show::CallKind::kSheet:
      return fmt::format("sheet {}", call.index + 1);
    case show::CallKind::kMotion:
      return "motion " + NameOf(show.motions, call.index);
    case show::CallKind::kBlink:
      return std::string(show::kBlinkNames[call.index % show::kBlinkNames.size()]);
    case show::CallKind::kGoTo:
      return call.index < show.cue_list.cues.size() ? "cue " + show.cue_list.cues[call.index].number
                                                    : "nothing";
  }
  return "nothing";
}

// The mode stands before the call, as in show.toml: "toggle face dog". The usual one is not said.
std::string Says(const show::Show& show, const show::Call& call) {
  const auto mode = static_cast<std::size_t>(call.mode);
  if (call.mode == show::CallMode::kCall || mode >= show::kCallModeNames.size()) return Calls(show, call);
  return fmt::format("{} {}", show::kCallModeNames[mode], Calls(show, call));
}

// What a key calls; motions' and scenes' own keys are compared with those.
std::string OnKey(const show::Show& show, std::uint16_t usage) {
  const auto key = std::ranges::find(show.keys, usage, &show::KeyCall::key_usage);
  return key == show.keys.end() ? "nothing" : Says(show, key->call);
}

bool SameCurve(const show::MotionCurve& a, const show::MotionCurve& b) {
  const auto same = [](const show::MotionKey& x, const show::MotionKey& y) {
    return x.at_s == y.at_s && x.value == y.value;
  };
  return a.target == b.target && a.channel == b.channel && std::ranges::equal(a.keys, b.keys, same);
}

std::string ChannelName(const show::Show& show, int index) {
  return index < 0 ? "nothing" : NameOf(show.cast.expressions, static_cast<std::size_t>(index));
}

// Each role's name and what plays it. Both shows have the same roles, so lists can be walked side by side.
std::vector<std::pair<std::string, std::string>> ChannelsOf(const show::Show& show) {
  const show::Channels& c = show.channels;
  std::vector<std::pair<std::string, std::string>> all{{"brow_up_left", ChannelName(show, c.brow_up[0])},
                                                       {"brow_up_right", ChannelName(show, c.brow_up[1])},
                                                       {"brow_frown", ChannelName(show, c.brow_frown)},
                                                       {"lids_up", ChannelName(show, c.lids_up)},
                                                       {"lids_down", ChannelName(show, c.lids_down)}};
  for (std::size_t i = 0; i < c.mouth.size(); ++i)
    all.emplace_back(fmt::format("mouth {}", i + 1), ChannelName(show, c.mouth[i]));
  return all;
}

// Null where it is no picture.
const face::Texture* PictureOf(const ScriptedScene& s) {
  const auto index = static_cast<std::size_t>(s.scene.backdrop.picture);
  return index < s.show.cast.textures.size() ? &s.show.cast.textures[index] : nullptr;
}

// Pictures are the same when they look the same, wherever they stand in the pack: their numbers are made
// equal before all else is compared.
bool SameBackdrop(const ScriptedScene& a, const ScriptedScene& b) {
  scene::Backdrop as_a = b.scene.backdrop;
  as_a.picture = a.scene.backdrop.picture;
  if (!(as_a == a.scene.backdrop)) return false;
  if (as_a.kind != scene::BackdropKind::kPicture) return true;
  const face::Texture* before = PictureOf(a);
  const face::Texture* after = PictureOf(b);
  return before != nullptr && after != nullptr && before->width_px == after->width_px &&
         before->rgba == after->rgba;
}

// A time below 0 is none of the item's own: the Fade dial has it.
std::string Fade(const show::ItemFade& fade) {
  const auto time = [](float s) {
    return s < 0 ? std::string("as the dial says") : fmt::format("{:.2f} s", s);
  };
  const auto curve = static_cast<std::size_t>(fade.curve);
  return fmt::format("in {}, out {}, {}", time(fade.in_s), time(fade.out_s),
                     curve < show::kFadeCurveNames.size() ? show::kFadeCurveNames[curve] : "nothing");
}

// Of what both shows have, by name.
void CompareFades(const show::Show& a, const show::Show& b, show::CallKind kind, Lines& lines) {
  const roles::Items items_of_a = roles::ItemsOf(a.cast), items_of_b = roles::ItemsOf(b.cast);
  const bool face = kind == show::CallKind::kFace;
  const auto& names_before = face ? items_of_a.faces : items_of_a.expressions;
  const auto& names = face ? items_of_b.faces : items_of_b.expressions;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto same = std::ranges::find(names_before, names[i]);
    if (same == names_before.end()) continue;
    const auto was = static_cast<std::uint16_t>(same - names_before.begin()),
               is = static_cast<std::uint16_t>(i);
    const auto before = Fade(show::FadeOf(a, {kind, was})), after = Fade(show::FadeOf(b, {kind, is}));
    if (before != after)
      lines.push_back(
          fmt::format("{} \"{}\": fade {} is now {}", face ? "face" : "expression", names[i], before, after));
  }
}

// A role that reads the same plays the same.
void CompareRoles(const show::Show& before_show, const show::Show& after_show, Lines& lines) {
  const show::Roles &a = before_show.roles, &b = after_show.roles;
  const roles::Items items_of_a = roles::ItemsOf(before_show.cast),
                     items_of_b = roles::ItemsOf(after_show.cast);
  const auto find = [](const show::Roles& in, const show::Role& role) {
    const auto found = std::ranges::find(in.roles, role.name, &show::Role::name);
    return found == in.roles.end() ? nullptr : &*found;
  };
  for (const show::Role& role : b.roles) {
    const show::Role* before = find(a, role);
    if (before == nullptr)
      lines.push_back(fmt::format("role \"{}\": is new", role.name));
    else if (roles::TextOf({.roles = {*before}, .mixes = a.mixes}, items_of_a) !=
             roles::TextOf({.roles = {role}, .mixes = b.mixes}, items_of_b))
      lines.push_back(fmt::format("role \"{}\": plays otherwise", role.name));
  }
  for (const show::Role& role : a.roles)
    if (find(b, role) == nullptr) lines.push_back(fmt::format("role \"{}\": is gone", role.name));
}

}  // namespace

// By curves and samples, not by how much: a motion is looked at.
void CompareMotion(const std::string& item, const show::Motion& a, const show::Motion& b, Lines& lines) {
  if (a.key_usage != b.key_usage) lines.push_back(item + ": is played by another key");
  if (!std::ranges::equal(a.curves, b.curves, SameCurve) || a.recorded != b.recorded)
    lines.push_back(item + ": moves otherwise");
  if (a.loop_from_s != b.loop_from_s || a.loop_to_s != b.loop_to_s)
    lines.push_back(item + ": loops otherwise");
  if (a.layer != b.layer) lines.push_back(item + ": lies in another layer");
  if (a.sound.channels != b.sound.channels || a.sound.samples != b.sound.samples)
    lines.push_back(item + ": sounds otherwise");
}

// Light and fade are compared as they are told, to a hundredth: what reads the same is no difference.
void CompareScene(const std::string& item, const ScriptedScene& a, const ScriptedScene& b, Lines& lines) {
  const auto compare = [&](const char* what, const std::string& before, const std::string& after) {
    if (before != after) lines.push_back(fmt::format("{}: {} {} is now {}", item, what, before, after));
  };
  compare("face", NameOf(a.show.cast.faces, a.scene.face), NameOf(b.show.cast.faces, b.scene.face));
  compare("expression", NameOf(a.show.cast.expressions, a.scene.expression),
          NameOf(b.show.cast.expressions, b.scene.expression));
  compare("style", StyleName(static_cast<std::size_t>(a.scene.style)),
          StyleName(static_cast<std::size_t>(b.scene.style)));
  compare("light", fmt::format("{:.2f}", a.scene.exposure), fmt::format("{:.2f}", b.scene.exposure));
  compare("fade", fmt::format("{:.2f} s", a.scene.fade_s), fmt::format("{:.2f} s", b.scene.fade_s));
  compare("backdrop", NameOf(a.scene.backdrop.kind), NameOf(b.scene.backdrop.kind));
  if (a.scene.backdrop.kind == b.scene.backdrop.kind && !SameBackdrop(a, b))
    lines.push_back(item + ": backdrop changed");
  if (a.scene.key_usage != b.scene.key_usage) lines.push_back(item + ": is called by another key");
}

// All buttons, then keys that are new or changed, then keys that are gone, then channels.
void CompareControls(const show::Show& a, const show::Show& b, Lines& lines) {
  // A box has a fixed number of buttons.
  for (std::size_t i = 0; i < a.buttons.size(); ++i)
    if (const auto before = Says(a, a.buttons[i]), after = Says(b, b.buttons[i]); before != after)
      lines.push_back(fmt::format("button {}: {} is now {}", i + 1, before, after));
  for (std::size_t i = 0; i < a.second_buttons.size(); ++i)
    if (const auto before = Says(a, a.second_buttons[i]), after = Says(b, b.second_buttons[i]);
        before != after)
      lines.push_back(fmt::format("button {} of the second sheet: {} is now {}", i + 1, before, after));
  for (std::size_t i = 0; i < a.stick_buttons.size(); ++i)
    if (const auto before = Says(a, a.stick_buttons[i]), after = Says(b, b.stick_buttons[i]); before != after)
      lines.push_back(fmt::format("button {} of the {}: {} is now {}", i % show::kStickButtonCount + 1,
                                  show::kDeviceNames[i / show::kStickButtonCount], before, after));
  for (const show::KeyCall& key : b.keys)
    if (const auto before = OnKey(a, key.key_usage), after = Says(b, key.call); before != after)
      lines.push_back(fmt::format("key {}: {} is now {}", key.key_usage, before, after));
  for (const show::KeyCall& key : a.keys)
    if (OnKey(b, key.key_usage) == "nothing")
      lines.push_back(fmt::format("key {}: {} is now nothing", key.key_usage, Says(a, key.call)));
  const auto before = ChannelsOf(a);
  const auto after = ChannelsOf(b);
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i].second != after[i].second)
      lines.push_back(
          fmt::format("channel {}: {} is now {}", before[i].first, before[i].second, after[i].second));
  CompareFades(a, b, show::CallKind::kFace, lines);
  CompareFades(a, b, show::CallKind::kExpression, lines);
  CompareRoles(a, b, lines);
}

}  // namespace kaori::authoring
