#include "appliance/core/show/cue.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "appliance/core/show/show.h"

namespace kaori::show {
namespace {

// The part of a number in front of its first dot, which is taken off.
std::string_view NextPart(std::string_view& number) {
  const std::size_t dot = std::min(number.find('.'), number.size());
  const std::string_view part = number.substr(0, dot);
  number.remove_prefix(std::min(dot + 1, number.size()));
  return part;
}

// Compares digits as numbers of any length.
std::strong_ordering CompareDigits(std::string_view a, std::string_view b) {
  a.remove_prefix(std::min(a.find_first_not_of('0'), a.size()));
  b.remove_prefix(std::min(b.find_first_not_of('0'), b.size()));
  return a.size() != b.size() ? a.size() <=> b.size() : a.compare(b) <=> 0;
}

// What was called before stays known, as Mixture::from has it in the performance.
void SetItem(TrackedState::Item& item, std::uint16_t index) {
  item = {index, item.now};
}

// Loops play on beside each other, and one that is called again begins anew. A motion that plays once leaves nothing
// behind, but where as many loops stand as can play it ends the first, as performance::PlayMotion does.
void AddMotion(std::vector<TrackedLoop>& loops, const Cue& cue, const Show& show) {
  if (cue.motion == kNoMotion) return;
  if (cue.motion == kEndsMotion) return loops.clear();
  std::erase_if(loops, [&cue](const TrackedLoop& loop) { return loop.motion == cue.motion; });
  if (loops.size() == kMostTakes) loops.erase(loops.begin());
  if (show.motions[static_cast<std::size_t>(cue.motion)].Loops()) loops.push_back({cue.motion, cue.use});
}

// The order is that in which the performance plays a cue: a scene sets four items, those named beside it then
// win.
void Add(TrackedState& state, const Cue& cue, const Show& show) {
  if (cue.scene) {
    const StageScene& scene = show.scenes[cue.scene->index];
    SetItem(state.scene, cue.scene->index);
    SetItem(state.face, scene.face);
    SetItem(state.expression, scene.expression);
    SetItem(state.style, static_cast<std::uint16_t>(scene.style));
    state.life = scene.life;
    state.gaze = scene.gaze;
  }
  if (cue.face) SetItem(state.face, cue.face->index);
  if (cue.expression) SetItem(state.expression, cue.expression->index);
  if (cue.style) SetItem(state.style, cue.style->index);
  if (cue.light) state.light = cue.light->value;
  if (cue.present) state.present = cue.present->value;
  for (std::size_t part = 0; cue.life && part < cue.life->size(); ++part)
    if ((*cue.life)[part] >= 0) state.life[part] = (*cue.life)[part];
  if (cue.gaze) state.gaze = *cue.gaze;
  AddMotion(state.loops, cue, show);
}

// The first scene, as performance::Opening enters it.
TrackedState OpeningState(const Show& show) {
  TrackedState state;
  if (show.scenes.empty()) return state;
  const StageScene& scene = show.scenes.front();
  const auto style = static_cast<std::uint16_t>(scene.style);
  state.face = {scene.face, scene.face};
  state.expression = {scene.expression, scene.expression};
  state.style = {style, style};
  state.life = scene.life;
  state.gaze = scene.gaze;
  return state;
}

// Numbered from 1, with the scenes' own fades: a show without a list plays as it did before there were lists.
void MakeCuesOfScenes(Show& show) {
  show.cue_list.of_scenes = true;
  for (std::size_t i = 1; i < show.scenes.size(); ++i) {
    Cue cue;
    cue.number = fmt::format("{}", i);
    cue.name = show.scenes[i].name;
    cue.scene = CueCall{static_cast<std::uint16_t>(i), show.scenes[i].fade_s};
    show.cue_list.cues.push_back(std::move(cue));
  }
}

}  // namespace

// A number with which another one begins comes before that: 2 < 2.1.
std::strong_ordering CompareCueNumbers(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty())
    if (const auto order = CompareDigits(NextPart(a), NextPart(b)); order != 0) return order;
  return a.empty() && b.empty() ? std::strong_ordering::equal
         : a.empty()            ? std::strong_ordering::less
                                : std::strong_ordering::greater;
}

// No dot at an end and no two in a row: each part has a digit, so that parts can be compared as numbers.
bool IsCueNumber(std::string_view text) {
  const auto is_part = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
  return !text.empty() && text.size() <= 32 && std::ranges::all_of(text, is_part) && text.front() != '.' &&
         text.back() != '.' && text.find("..") == std::string_view::npos;
}

// The last cue ends its chain whatever it says: nothing comes behind it.
std::size_t EndOfChain(const CueList& list, std::size_t cue) {
  while (cue + 1 < list.cues.size() && list.cues[cue].next != CueNext::kGo) ++cue;
  return cue;
}

// Each state is the one before with what the cue changes, so that a jump costs no more than a look at a list.
void Track(Show& show) {
  CueList& list = show.cue_list;
  if (list.cues.empty()) MakeCuesOfScenes(show);
  list.tracked = {OpeningState(show)};
  list.tracked.reserve(list.cues.size() + 1);
  for (const Cue& cue : list.cues) {
    TrackedState state = list.tracked.back();
    Add(state, cue, show);
    list.tracked.push_back(state);
  }
}

}  // namespace kaori::show
