#include <optional>

#include "appliance/authoring/script/show_parts.h"

namespace kaori::authoring {
namespace {

// What a button or a key calls: "face kaori". An empty text calls nothing. `section` holds it under `key`,
// for the faults.
show::Call ReadCall(Script& script, toml::Section& section, const std::string& key,
                    const toml::Value& value) {
  if (value.kind != toml::Value::Kind::kText) {
    section.Fault(key, "must be a text in quotes, such as \"face kaori\"");
    return {};
  }
  if (value.text.empty()) return {};
  const auto space = value.text.find(' ');
  const std::string kind = value.text.substr(0, space);
  const std::string name = space == std::string::npos ? "" : value.text.substr(space + 1);
  if (kind == "face") return {show::CallKind::kFace, FaceNamed(script, section, key, name)};
  if (kind == "expression") return {show::CallKind::kExpression, ExpressionNamed(script, section, key, name)};
  if (kind == "style") return {show::CallKind::kStyle, StyleNamed(section, key, name)};
  if (kind == "scene")
    return {show::CallKind::kScene, IndexOf(section, key, "scene", script.show.scenes, name)};
  if (kind == "cue") return {show::CallKind::kCue, CueVerbNamed(section, key, name)};
  section.Fault(key, fmt::format("\"{}\" is none of face, expression, style, scene, cue{}", kind,
                                 toml::DidYouMean(kind, {"face", "expression", "style", "scene", "cue"})));
  return {};
}

}  // namespace

// Rows are for the author's eye: all texts count through, and there must be as many as the box has buttons.
void ReadButtons(Script& script, const toml::Section& file) {
  toml::Section section = file;
  const toml::Value* rows = file.Find("buttons");
  if (rows->kind != toml::Value::Kind::kList) return section.Fault("buttons", "must be a list of rows [...]");
  std::size_t number = 0;
  for (const toml::Value& row : rows->list) {
    if (row.kind != toml::Value::Kind::kList) {
      script.faults.Add(row.line, "buttons", "a row [...] of texts is expected");
      continue;
    }
    for (const toml::Value& button : row.list) {
      // Each as a table of its own, so that its faults have its line.
      const std::string item = fmt::format("button {}", ++number);
      const toml::Value table{.line = button.line, .table = {{item, button}}};
      toml::Section one(table, "", script.faults);
      const show::Call call = ReadCall(script, one, item, button);
      if (number <= script.show.buttons.size()) script.show.buttons[number - 1] = call;
    }
  }
  if (number != script.show.buttons.size())
    section.Fault("buttons", fmt::format("{} are given; the box has {}", number, script.show.buttons.size()));
}

void ReadKeys(Script& script, toml::Section keys) {
  for (const auto& [name, value] : keys.table().table) {
    const std::uint16_t usage = KeyNamed(script, keys, name, name, "[keys]");
    script.show.keys.push_back({usage, ReadCall(script, keys, name, value)});
  }
}

}  // namespace kaori::authoring
