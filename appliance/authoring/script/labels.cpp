#include "appliance/authoring/script/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/board/keys.h"
#include "appliance/core/performance/knobs.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/roles/level_names.h"
#include "appliance/core/roles/own_buttons.h"
#include "drivers/base/json.h"
#include "firmware/wire/stick_pod.h"

namespace kaori::authoring {
namespace {

// What a dial of the box is called on the page, its unit, and what fills it: a call of the group `called_by`
// comes whole and fills the dial; a scene does so too. Null: only the operator turns it.
struct Dial {
  const char* text;
  const char* unit;
  const char* called_by;  // A call of this group comes whole and fills the dial; a scene does so too.
};
// In the order of show::Level.
constexpr std::array<Dial, performance::kKnobCount> kDials{{
    {"Face", "%", "face"},
    {"Expression", "%", "expression"},
    {"Strength", "%", nullptr},
    {"Fade time", "s", nullptr},
    {"Mouth", "%", nullptr},
    {"Mouth width", "%", nullptr},
    {"Life", "%", nullptr},
    {"Light", "%", nullptr},
}};

// Styles for people; show.toml has words of its own.
constexpr std::array<const char*, scene::kStyleCount> kStyles{"Wireframe", "Flat", "No hair", "Hair",
                                                              "Soft light"};
constexpr std::array<const char*, show::kCueVerbCount> kCueVerbs{"GO",    "Back",  "Stop",
                                                                 "Pause", "Panic", "Blackout"};

// As people write it: a float's 1.4 is not 1.39999998.
double Short(float value) {
  return std::round(static_cast<double>(value) * 1e4) / 1e4;
}

// The map of a dial; the first one, where two roles have it. Null: nobody plays it.
const show::RoleMap* MapOfDial(const show::Roles& roles, std::size_t dial) {
  for (const show::Role& role : roles.roles)
    for (const show::RoleMap& map : role.maps)
      if (show::Turns(map.control) && map.dial == dial) return &map;
  return nullptr;
}

// A level that is none of the first eight goes back to its rest: its dial has a name, and no number.
json::Object DialJson(const show::Show& show, const show::RoleMap& map, const performance::State& opening) {
  const show::LevelInfo& level = show::InfoOf(map.level);
  const auto index = static_cast<std::size_t>(map.level);
  if (!show::Stays(map.level))
    return {{"text", Readable(roles::LevelName(show.roles, map.level, roles::ItemsOf(show.cast)))}};
  const Dial& dial = kDials[index];
  return {{"text", dial.text},
          {"unit", dial.unit},
          {"low", Short(level.low)},
          {"high", Short(level.high)},
          {"per_turn", Short(map.to - map.from)},
          {"start", Short(opening.knobs[index])},
          {"filled_by", dial.called_by == nullptr ? json::List{} : json::List{dial.called_by, "scene"}}};
}

// Ranges and starting values are the performance's own, so a label cannot disagree with the dial.
json::List DialsJson(const show::Show& show) {
  const performance::State opening;
  json::List dials;
  for (std::size_t n = 0; n < kDials.size(); ++n) {
    const show::RoleMap* map = MapOfDial(show.roles, n);
    dials.push_back(map == nullptr ? json::Object{{"text", ""}} : DialJson(show, *map, opening));
  }
  return dials;
}

// Text and group of one control; empty for one that calls nothing.
struct CallLabel {
  std::string text;
  const char* group = "";
};

// Indices are in range: the show is valid.
CallLabel LabelOf(const show::Call& call, const show::Show& show) {
  const auto labelled = [](const std::string& text, const char* group) { return CallLabel{text, group}; };
  switch (call.kind) {
    case show::CallKind::kFace:
      return labelled(Readable(show.cast.faces[call.index].name), "face");
    case show::CallKind::kExpression:
      return labelled(Readable(show.cast.expressions[call.index].name), "expression");
    case show::CallKind::kStyle:
      return labelled(kStyles[call.index], "style");
    case show::CallKind::kScene:
      return labelled(Readable(show.scenes[call.index].name), "scene");
    case show::CallKind::kCue:
      return labelled(kCueVerbs[call.index], "cue");
    case show::CallKind::kSheet:
      return labelled(call.index == 0 ? "Sheet 1" : "Sheet 2", "sheet");
    case show::CallKind::kMotion:
      return labelled(Readable(show.motions[call.index].name), "motion");
    case show::CallKind::kBlink:
      return labelled(Readable(std::string(show::kBlinkNames[call.index])), "blink");
    case show::CallKind::kGoTo:
      return labelled("Cue " + show.cue_list.cues[call.index].number, "cue");
    case show::CallKind::kNothing:
      break;
  }
  return {};
}

// The group says which dial a call fills: toggles and buttons that are held fill none.
const char* GroupOf(const show::Call& call, const CallLabel& label) {
  return call.mode == show::CallMode::kCall ? label.group : "";
}

json::List ButtonsJson(std::span<const show::Call> calls, const show::Show& show) {
  json::List buttons;
  for (const show::Call& call : calls) {
    const CallLabel label = LabelOf(call, show);
    buttons.push_back(json::Object{{"text", label.text}, {"group", GroupOf(call, label)}});
  }
  return buttons;
}

// The two joysticks do the same in every show, but for what their buttons call. Only as many of these as ours have.
json::List SticksJson(const show::Show& show) {
  const auto buttons = [&show](std::size_t stick) {
    const auto calls = std::span(show.stick_buttons).subspan(stick * show::kStickButtonCount);
    return ButtonsJson(calls.first(wire::kStickPodButtons), show);
  };
  return {
      json::Object{{"text", "Head"}, {"twist", "Tilt"}, {"slide", "Lean in"}, {"buttons", buttons(0)}},
      json::Object{
          {"text", "Gaze and brows"}, {"twist", "Brows"}, {"slide", "Brows up"}, {"buttons", buttons(1)}}};
}

// In the order in which operators find them: blinks, registered motions, scenes, and what else keys call.
// Motions and scenes without a key are left out.
json::List KeysJson(const show::Show& show) {
  json::List keys;
  const auto add = [&keys](std::uint16_t usage, const std::string& text, const char* group) {
    if (usage != 0) keys.push_back(json::Object{{"usage", usage}, {"text", text}, {"group", group}});
  };
  add(board::key::kSpace, "Blink", "blink");
  // As the audience sees the face: its left is the character's right.
  add(board::key::kZ, "Wink left", "blink");
  add(board::key::kX, "Wink right", "blink");
  for (const show::Motion& motion : show.motions) add(motion.key_usage, Readable(motion.name), "motion");
  for (const show::StageScene& scene : show.scenes) add(scene.key_usage, Readable(scene.name), "scene");
  const auto add_call = [&](const show::KeyCall& key) {
    const CallLabel label = LabelOf(key.call, show);
    add(key.key_usage, label.text, GroupOf(key.call, label));
  };
  for (const show::KeyCall& key : show.keys)
    if (key.call.kind != show::CallKind::kCue) add_call(key);
  // In the order of the calls, GO first, and not by the names of their keys.
  for (std::uint16_t verb = 0; verb < show::kCueVerbCount; ++verb)
    for (const show::KeyCall& key : show.keys)
      if (key.call.kind == show::CallKind::kCue && key.call.index == verb) add_call(key);
  return keys;
}

// A show without a list of its own has its scenes as cues (show::Track), and its page lists none.
json::List CuesJson(const show::CueList& list) {
  json::List cues;
  if (list.of_scenes) return cues;
  for (std::size_t i = 0; i < list.cues.size(); ++i) {
    const show::Cue& cue = list.cues[i];
    const bool by_itself = i > 0 && list.cues[i - 1].next != show::CueNext::kGo;
    cues.push_back(json::Object{{"number", cue.number},
                                {"text", cue.name},
                                {"act", cue.act},
                                {"notes", cue.notes},
                                {"by_itself", by_itself}});
  }
  return cues;
}

// As board::Learn counts them: levels that every show has, faces, expressions; then what buttons may call; last the
// turn of a dial.
json::List TeachableJson(const show::Show& show) {
  json::List levels;
  for (std::size_t i = 0; i < show::kNamedLevels; ++i)
    levels.emplace_back(Readable(std::string(show::kLevels[i].name)));
  for (const face::Face& one : show.cast.faces) levels.emplace_back("Face " + Readable(one.name));
  for (const face::Expression& one : show.cast.expressions)
    levels.emplace_back("Expression " + Readable(one.name));
  const std::vector<std::string> calls = roles::TeachableCalls(roles::ItemsOf(show));
  for (std::size_t i = 0; i < calls.size(); ++i)
    levels.emplace_back(i < kCueVerbs.size() ? std::string("Call ") + kCueVerbs[i]
                                             : Readable("call " + calls[i]));
  levels.emplace_back("One turn of a dial");
  return levels;
}

// What a motion is added to, each once, in the order of MotionTarget.
std::string MovesOf(const show::Motion& motion) {
  constexpr std::array<const char*, show::kMotionTargetCount> kParts{"head", "head", "head",        "gaze",
                                                                     "gaze", "lids", "expressions", "head"};
  std::vector<std::string_view> parts;
  for (const show::MotionCurve& curve : motion.curves) {
    const std::string_view part = kParts[static_cast<std::size_t>(curve.target)];
    if (std::ranges::find(parts, part) == parts.end()) parts.push_back(part);
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

// Only ASCII letters are made large: the name may be in any script.
std::string Readable(std::string name) {
  std::ranges::replace(name, '_', ' ');
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

// In the order of show::Level, as many as the show's roles have. A share is told in per cent.
json::List LevelsJson(const show::Show& show) {
  json::List levels;
  const roles::Items items = roles::ItemsOf(show.cast);
  for (std::size_t i = 0; i < show::kNamedLevels + show.roles.mixes.size(); ++i) {
    const show::LevelInfo& level = show::kLevels[i];
    const std::string name = roles::LevelName(show.roles, static_cast<show::Level>(i), items);
    levels.push_back(json::Object{{"text", Readable(name)},
                                  {"unit", level.words.empty() ? std::string_view("%") : level.words},
                                  {"per_unit", level.words.empty() ? 0.01 : static_cast<double>(level.unit)},
                                  {"low", level.low},
                                  {"high", level.high},
                                  {"rest", level.rest}});
  }
  return levels;
}

// In the show's order, so that a name's place is the role's number on the board.
json::List RolesJson(const show::Roles& roles) {
  json::List names;
  for (const show::Role& role : roles.roles) names.emplace_back(role.name);
  return names;
}

// In the show's order, by which the stage counts.
json::List MotionsJson(const show::Show& show) {
  json::List motions;
  for (const show::Motion& motion : show.motions)
    motions.push_back(json::Object{{"text", Readable(motion.name)},
                                   {"length_s", Short(show::EndOf(motion))},
                                   {"loops", motion.Loops()},
                                   {"take", motion.recorded},
                                   {"sound", !motion.sound.samples.empty()},
                                   {"moves", MovesOf(motion)}});
  return motions;
}

std::string LabelsJson(const show::Show& show) {
  json::List scenes;
  for (const show::StageScene& scene : show.scenes) scenes.emplace_back(Readable(scene.name));
  const json::Object labels{{"show", show.name},
                            {"dials", DialsJson(show)},
                            {"buttons", ButtonsJson(show.buttons, show)},
                            {"second_buttons", ButtonsJson(show.second_buttons, show)},
                            {"sticks", SticksJson(show)},
                            {"scenes", scenes},
                            {"styles", json::ListOf(kStyles)},
                            {"keys", KeysJson(show)},
                            {"cues", CuesJson(show.cue_list)},
                            {"levels", LevelsJson(show)},
                            {"roles", RolesJson(show.roles)},
                            {"devices", json::ListOf(show::kDeviceNames)},
                            {"teachable", TeachableJson(show)},
                            {"motions", MotionsJson(show)}};
  // A name that is not UTF-8 is shown with replacement characters.
  return json::Write(labels, 1) + '\n';
}

}  // namespace kaori::authoring
