#include <algorithm>
#include <array>
#include <cmath>

#include "appliance/authoring/script/show_parts.h"
#include "appliance/core/board/calls.h"
#include "appliance/core/roles/level_names.h"

namespace kaori::authoring {
namespace {

// In the order of show::CueNext. A cue that does not say is "no": GO begins the next one.
constexpr std::array<std::string_view, 3> kNexts{"no", "continue", "follow"};

// One cue's keys, or those of [list].
class CueReader {
 public:
  CueReader(Script& script, toml::Section& section) : script_(script), section_(section) {}

  // "dog", or { name = "dog", in_s = 2 }. `index_of(section, key, name)` looks the name up.
  template <class IndexOfName>
  std::optional<show::CueCall> Call(std::string_view key, float otherwise_s, IndexOfName index_of) {
    const toml::Value* value = section_.Find(key);
    if (value == nullptr) return std::nullopt;
    if (value->kind == toml::Value::Kind::kText)
      return show::CueCall{index_of(section_, key, value->text), otherwise_s};
    toml::Section part = section_.Part(key);
    part.AllowOnly({"name", "in_s"});
    const std::string name = part.Text("name");
    const std::uint16_t index = name.empty() ? std::uint16_t{0} : index_of(part, "name", name);
    if (!part.Has("in_s")) return show::CueCall{index, otherwise_s};
    return show::CueCall{index, Between(part, "in_s", 0, show::kLongestCueFade_s, " s")};
  }

  // 0.4, or { to = 0.4, in_s = 2 }.
  std::optional<show::CueLevel> Level(std::string_view key) {
    const toml::Value* value = section_.Find(key);
    if (value == nullptr) return std::nullopt;
    if (value->kind == toml::Value::Kind::kNumber) return show::CueLevel{Share(section_, key), 0};
    toml::Section part = section_.Part(key);
    part.AllowOnly({"to", "in_s"});
    const float to = Share(part, "to");
    return show::CueLevel{to, Between(part, "in_s", 0, show::kLongestCueFade_s, " s")};
  }

  // -1 stands for the time of a scene that is named alone, without in_s: it then fades as it says itself.
  std::optional<show::CueCall> Scene(std::string_view key) {
    const auto named = [this](toml::Section& section, std::string_view at, const std::string& name) {
      return IndexOf(section, at, "scene", script_.show.scenes, name);
    };
    auto call = Call(key, -1, named);
    if (call && call->in_s < 0)
      call->in_s = script_.show.scenes.empty() ? 0 : script_.show.scenes[call->index].fade_s;
    return call;
  }

  // Levels by their names, as bits.
  std::uint32_t Release() {
    std::uint32_t levels = 0;
    if (!section_.Has("release")) return levels;
    const show::Show& show = script_.show;
    const roles::Items items = roles::ItemsOf(show.cast);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < show::kNamedLevels + show.roles.mixes.size(); ++i)
      names.push_back(roles::LevelName(show.roles, static_cast<show::Level>(i), items));
    for (const std::string& name : section_.Texts("release")) {
      const auto found = std::ranges::find(names, name);
      if (found != names.end())
        levels |= 1U << static_cast<unsigned>(found - names.begin());
      else
        section_.Fault("release", fmt::format("there is no level \"{}\"{}", name,
                                              toml::DidYouMean(name, {names.begin(), names.end()})));
    }
    return levels;
  }

  // A word that is none of these is a fault and reads as "no", so that the rest of the file can be judged.
  show::CueNext Next() {
    const std::string name = section_.TextOr("continue", kNexts.front());
    const auto found = std::ranges::find(kNexts, name);
    if (found != kNexts.end()) return static_cast<show::CueNext>(found - kNexts.begin());
    section_.Fault("continue", fmt::format("\"{}\" is none of no, continue, follow", name));
    return show::CueNext::kGo;
  }

 private:
  static float Share(toml::Section& section, std::string_view key) {
    const auto value = static_cast<float>(section.Number(key));
    if (!(value >= 0 && value <= 1)) section.Fault(key, fmt::format("is {}, not within 0 to 1", value));
    return value;
  }

  Script& script_;
  toml::Section& section_;
};

// Two numbers with one key (board::CueKey) are refused, however unlikely: a call carries the key alone.
std::string ReadNumber(Script& script, toml::Section& section) {
  std::string number = section.Text("number");
  if (number.empty()) return number;
  if (!show::IsCueNumber(number)) {
    section.Fault("number", fmt::format("\"{}\" is no number of a cue: digits and single dots", number));
    return number;
  }
  const auto& cues = script.show.cue_list.cues;
  if (!cues.empty() && show::IsCueNumber(cues.back().number) &&
      show::CompareCueNumbers(number, cues.back().number) <= 0)
    section.Fault("number", fmt::format("{} stands after {}; numbers must rise from cue to cue", number,
                                        cues.back().number));
  const auto same_key = [&number](const show::Cue& cue) {
    return cue.number != number && board::CueKey(cue.number) == board::CueKey(number);
  };
  if (const auto other = std::ranges::find_if(cues, same_key); other != cues.end())
    section.Fault("number", fmt::format("{} and {} cannot be told apart by a call; choose another", number,
                                        other->number));
  return number;
}

// True or nothing: no cue unlocks.
bool IsLocked(toml::Section& section) {
  const toml::Value* lock = section.Find("lock");
  if (lock == nullptr) return false;
  if (lock->kind != toml::Value::Kind::kSwitch || !lock->on)
    section.Fault("lock", "must be true, or not stand here: the service key alone unlocks a show");
  return true;
}

// Faces, expressions and styles fade in 1 s where the cue gives no time; light and presence are cut.
show::Cue ReadCue(Script& script, toml::Section section) {
  section.AllowOnly({"number", "name", "act", "notes", "pre_wait_s", "scene", "face", "expression", "style",
                     "light", "present", "motion", "take", "release", "life", "gaze", "lock", "continue",
                     "wait_for"});
  CueReader read(script, section);
  show::Cue cue;
  cue.number = ReadNumber(script, section);
  cue.name = section.TextOr("name", "");
  cue.act = section.TextOr("act", "");
  cue.notes = section.TextOr("notes", "");
  cue.pre_wait_s = Between(section, "pre_wait_s", 0, show::kLongestWait_s, " s");
  cue.scene = read.Scene("scene");
  const auto face = [&script](toml::Section& at, std::string_view key, const std::string& name) {
    return FaceNamed(script, at, key, name);
  };
  const auto expression = [&script](toml::Section& at, std::string_view key, const std::string& name) {
    return ExpressionNamed(script, at, key, name);
  };
  cue.face = read.Call("face", 1, face);
  cue.expression = read.Call("expression", 1, expression);
  cue.style = read.Call("style", 1, StyleNamed);
  cue.light = read.Level("light");
  cue.present = read.Level("present");
  ReadCueMotion(script, section, cue);
  cue.release = read.Release();
  if (section.Has("life")) cue.life = LifeAt(section, "life", show::kKeepsLife);
  if (section.Has("gaze")) cue.gaze = GazeNamed(script, section, "gaze", section.Text("gaze"));
  cue.lock = IsLocked(section);
  cue.next = read.Next();
  CheckFollow(script, section, cue);
  cue.wait = ReadCueWait(script, section);
  return cue;
}

// A [[cue]] by its number: faults call it "cue 2.10" rather than "cue[7]".
toml::Section Numbered(Script& script, const toml::Section& section, std::size_t count) {
  const toml::Value* number = section.Find("number");
  const bool numbered =
      number != nullptr && number->kind == toml::Value::Kind::kText && !number->text.empty();
  return {section.table(), numbered ? fmt::format("cue {}", number->text) : fmt::format("cue[{}]", count),
          script.faults};
}

// [list]: what holds for all cues. The guard alone is written in milliseconds.
void ReadList(Script& script, toml::Section section) {
  section.AllowOnly({"go_guard_ms", "goto_s", "panic"});
  show::CueList& list = script.show.cue_list;
  const double guard_ms = section.NumberOr("go_guard_ms", 300);
  if (!(guard_ms >= 0 && guard_ms <= 1000 * show::kLongestGoGuard_s))
    section.Fault("go_guard_ms",
                  fmt::format("is {} ms, not within 0 to {}", guard_ms, 1000 * show::kLongestGoGuard_s));
  list.go_guard_s = static_cast<float>(guard_ms / 1000);
  list.goto_s = Between(section, "goto_s", list.goto_s, show::kLongestFade_s, " s");
  list.panic = CueReader(script, section).Scene("panic").value_or(list.panic);
}

}  // namespace

// A last cue that would bring another one is a fault at its own line.
void ReadCueList(Script& script, toml::Section file) {
  file.AllowOnly({"list", "cue"});
  if (file.Has("list")) ReadList(script, file.Part("list"));
  std::size_t count = 0;
  for (const toml::Section& cue : file.Parts("cue"))
    script.show.cue_list.cues.push_back(ReadCue(script, Numbered(script, cue, ++count)));
  if (count == 0) file.Fault("cue", "there is none; without this file GO calls the scenes in their order");
  if (count > show::kMostCues)
    file.Fault("cue", fmt::format("there are {}, and {} is the most", count, show::kMostCues));
  if (count > 0 && script.show.cue_list.cues.back().next != show::CueNext::kGo)
    script.faults.Add(file.Parts("cue").back().table().line,
                      fmt::format("cue {}", script.show.cue_list.cues.back().number),
                      "it is the last one: no cue continues or follows it");
}

}  // namespace kaori::authoring
