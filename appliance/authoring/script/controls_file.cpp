#include <algorithm>
#include <array>

#include <fmt/ranges.h>

#include "appliance/authoring/script/show_parts.h"
#include "appliance/core/roles/own_buttons.h"

namespace kaori::authoring {
namespace {

// The first word of a text, and the rest.
struct Words {
  std::string first, rest;
};
Words Split(const std::string& text) {
  const auto space = text.find(' ');
  return {text.substr(0, space), space == std::string::npos ? "" : text.substr(space + 1)};
}

// Sheets are 1 and 2 in the file, 0 and 1 in a call.
std::uint16_t SheetNamed(toml::Section& section, const std::string& key, const std::string& name) {
  if (name != "1" && name != "2")
    section.Fault(key, fmt::format("there is no sheet \"{}\", but 1 and 2", name));
  return name == "2" ? 1 : 0;
}

constexpr std::array<std::string_view, 10> kItemKinds{"face",  "expression", "style",  "scene", "cue",
                                                      "sheet", "take",       "motion", "blink", "wink"};

// "cue go", or "cue 14" for a jump to that one. A show without a list of its own has its scenes as cues, which
// are called as scenes.
show::Call CueCalled(const Script& script, toml::Section& section, const std::string& key,
                     const std::string& name) {
  if (!show::IsCueNumber(name)) return {show::CallKind::kCue, CueVerbNamed(section, key, name)};
  const auto& cues = script.show.cue_list.cues;
  const auto found = std::ranges::find(cues, name, &show::Cue::number);
  if (found != cues.end()) return {show::CallKind::kGoTo, static_cast<std::uint16_t>(found - cues.begin())};
  if (!script.knows_cues) return {};
  std::vector<std::string_view> numbers;
  for (const show::Cue& cue : cues) numbers.emplace_back(cue.number);
  section.Fault(key, cues.empty()
                         ? fmt::format("there is no cue \"{}\": the show has no cues.toml", name)
                         : fmt::format("there is no cue \"{}\"{}", name, toml::DidYouMean(name, numbers)));
  return {};
}

// "blink", "wink left", "wink right": as they lie before the operator.
show::Call BlinkCalled(toml::Section& section, const std::string& key, const std::string& text) {
  const auto* const found = std::ranges::find(show::kBlinkNames, text);
  if (found != show::kBlinkNames.end())
    return {show::CallKind::kBlink, static_cast<std::uint16_t>(found - show::kBlinkNames.begin())};
  section.Fault(key, fmt::format("\"{}\" is none of {}", text, fmt::join(show::kBlinkNames, ", ")));
  return {};
}

// "face kaori". `section` holds it under `key`, for the faults.
// A name that is not there is a fault and gives number 0 of its kind; a word that is no kind
// gives a call of nothing.
show::Call ReadItem(Script& script, toml::Section& section, const std::string& key, const std::string& text) {
  const auto [kind, name] = Split(text);
  if (kind == "face") return {show::CallKind::kFace, FaceNamed(script, section, key, name)};
  if (kind == "expression") return {show::CallKind::kExpression, ExpressionNamed(script, section, key, name)};
  if (kind == "style") return {show::CallKind::kStyle, StyleNamed(section, key, name)};
  if (kind == "scene")
    return {show::CallKind::kScene, IndexOf(section, key, "scene", script.show.scenes, name)};
  if (kind == "cue") return CueCalled(script, section, key, name);
  if (kind == "blink" || kind == "wink") return BlinkCalled(section, key, text);
  if (kind == "sheet") return {show::CallKind::kSheet, SheetNamed(section, key, name)};
  if (kind == "take" || kind == "motion")
    return {show::CallKind::kMotion, IndexOf(section, key, kind.c_str(), script.show.motions, name)};
  section.Fault(key, fmt::format("\"{}\" is none of {}{}", kind, fmt::join(kItemKinds, ", "),
                                 toml::DidYouMean(kind, {kItemKinds.begin(), kItemKinds.end()})));
  return {};
}

// What a button or a key calls, and how: "face kaori", "toggle expression angry". An empty text calls
// nothing.
show::Call ReadCall(Script& script, toml::Section& section, const std::string& key,
                    const toml::Value& value) {
  if (value.kind != toml::Value::Kind::kText) {
    section.Fault(key, "must be a text in quotes, such as \"face kaori\"");
    return {};
  }
  if (value.text.empty()) return {};
  const auto [first, rest] = Split(value.text);
  const auto* const mode = std::ranges::find(show::kCallModeNames, first);
  if (mode == show::kCallModeNames.end()) return ReadItem(script, section, key, value.text);
  show::Call call = ReadItem(script, section, key, rest);
  call.mode = static_cast<show::CallMode>(mode - show::kCallModeNames.begin());
  if (call.mode != show::CallMode::kCall && call.kind != show::CallKind::kNothing && !show::Joins(call.kind))
    section.Fault(key, fmt::format("\"{}\" is for faces, expressions and sheets", first));
  return call;
}

// A time that is not written is none of the item's own, which ItemFade has as a number below 0.
float FadeTime(toml::Section& section, std::string_view key) {
  if (!section.Has(key)) return show::ItemFade().in_s;
  return Between(section, key, 0, show::kLongestItemFade_s, " s");
}

// The first name of the list is that of the usual curve.
show::FadeCurve ReadCurve(toml::Section& section) {
  const std::string name = section.TextOr("curve", std::string(show::kFadeCurveNames.front()));
  const auto* const found = std::ranges::find(show::kFadeCurveNames, name);
  if (found == show::kFadeCurveNames.end())
    section.Fault("curve", fmt::format("\"{}\" is none of {}", name, fmt::join(show::kFadeCurveNames, ", ")));
  return found == show::kFadeCurveNames.end()
             ? show::FadeCurve::kS
             : static_cast<show::FadeCurve>(found - show::kFadeCurveNames.begin());
}

}  // namespace

// Keys are what a button would call, "face kaori" or "expression angry". Each list is as long as its last
// item with a fade needs; items behind that have none of their own.
void ReadFades(Script& script, toml::Section fades) {
  for (const auto& entry : fades.table().table) {
    const auto [kind, name] = Split(entry.first);
    const bool face = kind == "face";
    if (!face && kind != "expression") {
      fades.Fault(entry.first, "is none of \"face ...\" and \"expression ...\"");
      continue;
    }
    const std::size_t index = face ? FaceNamed(script, fades, entry.first, name)
                                   : ExpressionNamed(script, fades, entry.first, name);
    toml::Section fade = fades.Part(entry.first);
    fade.AllowOnly({"in_s", "out_s", "curve"});
    auto& into = face ? script.show.face_fades : script.show.expression_fades;
    if (into.size() <= index) into.resize(index + 1);
    into[index] = {FadeTime(fade, "in_s"), FadeTime(fade, "out_s"), ReadCurve(fade)};
  }
}

// Rows are for the author's eye: all texts count through, and there must be as many as the box has buttons.
void ReadButtons(Script& script, const toml::Section& file, const std::string& list,
                 std::array<show::Call, show::kButtonCount>& into) {
  toml::Section section = file;
  const toml::Value* rows = file.Find(list);
  if (rows->kind != toml::Value::Kind::kList) return section.Fault(list, "must be a list of rows [...]");
  std::size_t number = 0;
  for (const toml::Value& row : rows->list) {
    if (row.kind != toml::Value::Kind::kList) {
      script.faults.Add(row.line, list, "a row [...] of texts is expected");
      continue;
    }
    for (const toml::Value& button : row.list) {
      // Each as a table of its own, so that its faults have its line.
      const std::string item = fmt::format("button {}", ++number);
      const toml::Value table{.line = button.line, .table = {{item, button}}};
      toml::Section one(table, "", script.faults);
      const show::Call call = ReadCall(script, one, item, button);
      if (number <= into.size()) into[number - 1] = call;
    }
  }
  if (number != into.size())
    section.Fault(list, fmt::format("{} are given; the box has {}", number, into.size()));
}

// Scenes and motions have been read and have their keys; KeyNamed refuses those here, and keys of the box.
void ReadKeys(Script& script, toml::Section keys) {
  for (const auto& [name, value] : keys.table().table) {
    const std::uint16_t usage = KeyNamed(script, keys, name, name, "[keys]");
    script.show.keys.push_back({usage, ReadCall(script, keys, name, value)});
  }
}

// The dial box's have their rows in show.toml, and one place each is enough. Two tables of one button are a
// fault of the second one.
void ReadStickButtons(Script& script, toml::Section file) {
  std::size_t count = 0;
  std::vector<std::uint8_t> given;
  for (const toml::Section& one : file.Parts("button")) {
    toml::Section button(one.table(), fmt::format("button[{}]", ++count), script.faults);
    const roles::NamedButton named = roles::ReadNamedButton(button);
    const toml::Value* const value = button.Find("call");
    const show::Call call = value == nullptr ? show::Call() : ReadCall(script, button, "call", *value);
    if (value == nullptr) button.Fault("call", "is missing, such as \"cue go\"");
    if (named.device == show::Device::kDialBox) {
      button.Fault("device", "must be a stick: buttons of the dial box stand in show.toml, under buttons");
      continue;
    }
    const std::uint8_t number = roles::ButtonNamed(named);
    if (std::ranges::find(given, number) != given.end())
      button.Fault("number", fmt::format("button {} is given twice", named.number));
    given.push_back(number);
    script.show.stick_buttons[number - std::size_t{show::kButtonCount}] = call;
  }
}

}  // namespace kaori::authoring
