#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "appliance/authoring/pack/difference_parts.h"
#include "appliance/core/roles/level_names.h"
#include "render/scene/scene.h"

namespace kaori::authoring {
namespace {

// What one cue says under each key of cues.toml, in the words of that file.
using CueFacts = std::vector<std::pair<const char*, std::string>>;

// "nothing" for a number that no item has, so that two packs can be compared whatever they hold.
template <class Items>
std::string NameAt(const Items& items, std::int64_t index) {
  return index >= 0 && static_cast<std::size_t>(index) < items.size()
             ? items[static_cast<std::size_t>(index)].name
             : "nothing";
}

// An empty text is of what the cue does not name: it leaves that as it was.
std::string CallOf(const std::optional<show::CueCall>& call, const std::string& name) {
  return call ? fmt::format("{} in {:.2f} s", name, call->in_s) : "";
}

std::string LevelOf(const std::optional<show::CueLevel>& level) {
  return level ? fmt::format("{:.2f} in {:.2f} s", level->value, level->in_s) : "";
}

// A layer that is not named is the motion's own, which is compared with the motion.
std::string MotionOf(const show::Show& show, const show::Cue& cue) {
  if (cue.motion == show::kNoMotion) return "";
  if (cue.motion == show::kEndsMotion) return "none";
  std::string said = NameAt(show.motions, cue.motion);
  if (cue.use.layer) {
    const auto layer = static_cast<std::size_t>(*cue.use.layer);
    said += fmt::format(" {}",
                        layer < show::kMotionLayerNames.size() ? show::kMotionLayerNames[layer] : "nothing");
  }
  if (cue.use.gain != 1) said += fmt::format(", gain {:.2f}", cue.use.gain);
  if (cue.use.from_s > 0) said += fmt::format(", from {:.2f} s", cue.use.from_s);
  return said;
}

std::string ReleaseOf(const show::Show& show, const show::Cue& cue) {
  std::string said;
  const roles::Items items = roles::ItemsOf(show.cast);
  for (std::size_t i = 0; i < show::kNamedLevels + show.roles.mixes.size(); ++i)
    if ((cue.release >> i & 1U) != 0)
      said += (said.empty() ? "" : ", ") + roles::LevelName(show.roles, static_cast<show::Level>(i), items);
  return said;
}

std::string LifeOf(const show::Cue& cue) {
  std::string said;
  for (std::size_t part = 0; cue.life && part < cue.life->size(); ++part)
    said += (part == 0 ? "" : " ") + ((*cue.life)[part] < 0 ? "-" : fmt::format("{:.2f}", (*cue.life)[part]));
  return said;
}

std::string NextOf(const show::Cue& cue) {
  constexpr std::array<const char*, 3> kNextNames{"no", "continue", "follow"};
  const auto next = static_cast<std::size_t>(cue.next);
  return next < kNextNames.size() ? kNextNames[next] : "nothing";
}

std::string WaitOf(const show::Show& show, const show::Cue& cue) {
  const show::CueWait& wait = cue.wait;
  const auto says = [&wait](const char* what) {
    return fmt::format("{} {:.2f} s, at most {:.2f} s", what, wait.for_s, wait.at_most_s);
  };
  switch (wait.person) {
    case show::CuePerson::kNobody:
      return "";
    case show::CuePerson::kMouthShut:
      return says("mouth_shut");
    case show::CuePerson::kVoiceQuiet:
      return says("voice_quiet");
    case show::CuePerson::kPresence:
      return says("presence");
    case show::CuePerson::kGazeOn:
      return says(fmt::format("gaze_on {}", NameAt(show.gaze_targets, wait.target)).c_str());
  }
  return "nothing";
}

std::string StyleOf(const show::Cue& cue) {
  return cue.style && cue.style->index < scene::kStyleNames.size() ? scene::kStyleNames[cue.style->index]
                                                                   : "nothing";
}

// In the order of the guide's page.
CueFacts SaidBy(const show::Show& show, const show::Cue& cue) {
  const auto index = [](const std::optional<show::CueCall>& call) { return call ? call->index : -1; };
  const std::string gaze = !cue.gaze                      ? ""
                           : *cue.gaze == show::kNoTarget ? "nobody"
                                                          : NameAt(show.gaze_targets, *cue.gaze);
  return {{"name", cue.name},
          {"act", cue.act},
          {"notes", cue.notes},
          {"scene", CallOf(cue.scene, NameAt(show.scenes, index(cue.scene)))},
          {"face", CallOf(cue.face, NameAt(show.cast.faces, index(cue.face)))},
          {"expression", CallOf(cue.expression, NameAt(show.cast.expressions, index(cue.expression)))},
          {"style", CallOf(cue.style, StyleOf(cue))},
          {"light", LevelOf(cue.light)},
          {"present", LevelOf(cue.present)},
          {"motion", MotionOf(show, cue)},
          {"release", ReleaseOf(show, cue)},
          {"gaze", gaze},
          {"life", LifeOf(cue)},
          {"lock", cue.lock ? "true" : ""},
          {"pre_wait_s", fmt::format("{:.2f}", cue.pre_wait_s)},
          {"wait_for", WaitOf(show, cue)},
          {"continue", NextOf(cue)}};
}

std::string Word(const std::string& said) {
  return said.empty() ? "nothing" : said;
}

// A list that was made of the scenes is none of its own: scenes are compared as scenes.
const show::Cue* FindCue(const show::CueList& list, const std::string& number) {
  if (list.of_scenes) return nullptr;
  const auto found = std::ranges::find(list.cues, number, &show::Cue::number);
  return found == list.cues.end() ? nullptr : &*found;
}

}  // namespace

// Numbers are compared as they are told, to a hundredth: what reads the same is no difference.
void CompareCues(const show::Show& a, const show::Show& b, Lines& lines) {
  const auto compare = [&lines](const std::string& item, const char* what, const std::string& before,
                                const std::string& after) {
    if (before != after)
      lines.push_back(fmt::format("{}: {} {} is now {}", item, what, Word(before), Word(after)));
  };
  const auto seconds = [](float s) { return fmt::format("{:.2f} s", s); };
  const auto panic = [](const show::Show& show) {
    return CallOf(show.cue_list.panic, NameAt(show.scenes, show.cue_list.panic.index));
  };
  compare("cue list", "go_guard", seconds(a.cue_list.go_guard_s), seconds(b.cue_list.go_guard_s));
  compare("cue list", "goto_s", seconds(a.cue_list.goto_s), seconds(b.cue_list.goto_s));
  compare("cue list", "panic", panic(a), panic(b));
  for (const show::Cue& cue : a.cue_list.cues) {
    if (a.cue_list.of_scenes) break;
    const show::Cue* now = FindCue(b.cue_list, cue.number);
    const std::string item = "cue " + cue.number;
    if (now == nullptr) {
      lines.push_back(item + ": is gone");
      continue;
    }
    const CueFacts before = SaidBy(a, cue), after = SaidBy(b, *now);
    for (std::size_t i = 0; i < before.size(); ++i)
      compare(item, before[i].first, before[i].second, after[i].second);
  }
  for (const show::Cue& cue : b.cue_list.cues)
    if (!b.cue_list.of_scenes && FindCue(a.cue_list, cue.number) == nullptr)
      lines.push_back(fmt::format("cue {}: is new", cue.number));
}

}  // namespace kaori::authoring
