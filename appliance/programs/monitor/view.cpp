#include "appliance/programs/monitor/view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "appliance/core/board/lines.h"
#include "appliance/core/board/mouth.h"
#include "appliance/core/performance/motions.h"
#include "appliance/programs/monitor/levels.h"
#include "appliance/programs/monitor/palette.h"

namespace kaori::monitor {
namespace {

using namespace std::chrono_literals;
using board::SourceState;

constexpr float kRefusedShown_s = 2;
constexpr Duration kAlive = 2s;  // A writer that is silent for longer says nothing of now.
constexpr float kQuietest_db = -60;

// In the order of board::LobbyState.
constexpr std::array<const char*, board::kLobbyStateCount> kLobbyWords{"",
                                                                       "LOBBY asleep",
                                                                       "LOBBY waiting",
                                                                       "LOBBY greeting",
                                                                       "LOBBY with a visitor",
                                                                       "LOBBY good-bye",
                                                                       "LOBBY taken over"};

template <class Names>
std::string NameAt(const Names& items, std::size_t index) {
  return index < items.size() ? items[index].name : std::string();
}

CueWords WordsOf(const show::CueList& list, std::int32_t cue) {
  if (cue < 0 || std::size_t(cue) >= list.cues.size()) return {};
  const show::Cue& of = list.cues[std::size_t(cue)];
  return {of.number, of.name, of.notes};
}

// Acts are named by the cue that opens them.
void AddAct(const Moment& moment, View& view) {
  const auto& cues = moment.show.cue_list.cues;
  const board::ShowNow& now = moment.show_now.value;
  if (now.cue_active < 0 || std::size_t(now.cue_active) >= cues.size()) return;
  auto opener = std::size_t(now.cue_active);
  while (opener > 0 && cues[opener].act.empty()) --opener;
  view.act = cues[opener].act.empty() ? "CUE LIST" : "ACT " + cues[opener].act;
  if (now.act_began != Time{}) view.act_time = ClockText(moment.now - now.act_began);
}

// The guard is of a fraction of a second: its mark says why a second tap does nothing.
Tag GoOf(const Moment& moment) {
  const performance::State& state = moment.state;
  const show::CueList& list = moment.show.cue_list;
  if (list.cues.empty()) return {"no cue list", kQuiet};
  if (state.cue_run.since_refused_s < kRefusedShown_s) return {"GO refused", kAmber};
  if (std::size_t(std::max(0, moment.show_now.value.cue_standby)) >= list.cues.size())
    return {"end of list", kQuiet};
  if (state.go_quiet_s < list.go_guard_s) return {"GO guard", kQuiet};
  return {"GO", kGreen};
}

// The number of the cue that comes, and what it waits for.
std::string ComesOf(const Moment& moment) {
  using Phase = performance::CueRun::Phase;
  const board::ShowNow& now = moment.show_now.value;
  const auto& cues = moment.show.cue_list.cues;
  if (now.cue_pending < 0 || std::size_t(now.cue_pending) >= cues.size()) return {};
  const CueWords cue = WordsOf(moment.show.cue_list, now.cue_pending);
  const double left_s = std::ceil(double{now.cue_left_s} * 10) / 10;  // Tenths, so that 0.0 is never told.
  switch (moment.state.cue_run.phase) {
    case Phase::kPreWait:
      return fmt::format("{} comes in {:.1f} s", cue.number, left_s);
    case Phase::kFollow:
      return fmt::format("{} follows in {:.1f} s", cue.number, left_s);
    case Phase::kPerson:
      break;
    case Phase::kIdle:
      return {};
  }
  const char* what = "a person";
  switch (cues[std::size_t(now.cue_pending)].wait.person) {
    case show::CuePerson::kMouthShut:
      what = "a shut mouth";
      break;
    case show::CuePerson::kVoiceQuiet:
      what = "a quiet voice";
      break;
    case show::CuePerson::kPresence:
      what = "somebody";
      break;
    case show::CuePerson::kGazeOn:
      what = "a look";
      break;
    case show::CuePerson::kNobody:
      break;
  }
  return fmt::format("{} waits for {}, {:.1f} s at most", cue.number, what, left_s);
}

void AddMarks(const Moment& moment, View& view) {
  const board::ShowNow& now = moment.show_now.value;
  const bool is_black =
      (now.cue_state & board::kCuesBlack) != 0 || board::IsOn(moment.lines.value, board::Line::kBlackout);
  if ((now.cue_state & board::kCuesPanicking) != 0) view.marks.push_back({"PANIC", kRed});
  if (is_black) view.marks.push_back({"BLACKOUT", kRed});
  if ((now.cue_state & board::kCuesPaused) != 0) view.marks.push_back({"PAUSED", kAmber});
  if (now.locked != 0)
    view.marks.push_back(
        {now.locked_out == 0 ? "LOCKED" : fmt::format("LOCKED, {} refused", now.locked_out), kBlue});
  if (now.sheet != 0) view.marks.push_back({fmt::format("SHEET {}", now.sheet + 1), kScene});
  const auto lobby = static_cast<std::size_t>(now.lobby);
  if (lobby != 0 && lobby < kLobbyWords.size())
    view.marks.push_back(
        {kLobbyWords[lobby] + std::string(now.lobby_hours == board::LobbyHours::kShut ? ", shut" : ""),
         kStyle});
}

// What people keep beside the face that was called joins it.
std::string NameWithJoined(const Moment& moment, show::CallKind kind, std::string name) {
  for (const performance::Kept& kept : moment.state.kept) {
    if (kept.call.kind != kind || kept.on == 0) continue;
    const bool face = kind == show::CallKind::kFace;
    name += " + " + (face ? NameAt(moment.show.cast.faces, kept.call.index)
                          : NameAt(moment.show.cast.expressions, kept.call.index));
  }
  return name;
}

void AddMotions(const Moment& moment, View& view) {
  for (const performance::Playing& voice : moment.state.voices) {
    if (voice.motion < 0 || voice.ends != 0 || std::size_t(voice.motion) >= moment.show.motions.size())
      continue;
    const show::Motion& motion = moment.show.motions[std::size_t(voice.motion)];
    const float end_s = motion.Loops() ? 0 : show::EndOf(motion);
    view.playing.push_back({"motion", motion.Loops() ? motion.name + " (loops)" : motion.name, kMotion,
                            end_s > 0 ? std::clamp(voice.at_s / end_s, 0.0F, 1.0F) : 1});
  }
}

void AddPlaying(const Moment& moment, View& view) {
  const performance::State& state = moment.state;
  const show::Show& show = moment.show;
  const auto joined = [&](show::CallKind kind, std::string name) {
    return NameWithJoined(moment, kind, std::move(name));
  };
  view.playing = {
      {"face", joined(show::CallKind::kFace, NameAt(show.cast.faces, state.faces.to)), kFace,
       state.faces.progress},
      {"expression", joined(show::CallKind::kExpression, NameAt(show.cast.expressions, state.expressions.to)),
       kExpression, state.expressions.progress},
      {"scene", NameAt(show.scenes, state.scene), kScene, state.backdrops.progress},
      {"drawing", state.styles.to < scene::kStyleNames.size() ? scene::kStyleNames[state.styles.to] : "",
       kStyle, state.styles.progress}};
  AddMotions(moment, view);
}

// Who has the mouth where lips and voice are both there is told by the levels.
void AddLips(const Moment& moment, View& view) {
  const auto& [lips, at, source] = moment.lips;
  if (source == SourceState::kAbsent) {
    view.lips = {"no camera", kQuiet};
  } else if (source == SourceState::kStale || moment.now - at > kAlive) {
    view.lips = {"the camera is gone", kAmber};
  } else if (!board::IsUsable(lips)) {
    view.lips = {"no painted mouth is seen", kAmber};
  } else {
    view.lips = {"the mouth is seen", kGreen};
    view.open = board::PositionOf(lips).open;
  }
  const auto& voice = moment.voice;
  if (voice.source != SourceState::kLive) return;
  view.voice = std::clamp((voice.value.level_db - kQuietest_db) / -kQuietest_db, 0.0F, 1.0F);
  view.speaks = voice.value.speaking != 0;
}

// Faults in their own words, else the names of what is missing: the status picture says more.
Tag FaultOf(const std::vector<status::Line>& lines) {
  std::vector<std::string> missing;
  std::size_t faults = 0;
  std::string first;
  for (const auto& [mark, what, words] : lines) {
    if (mark == status::Mark::kMissing && std::ranges::find(missing, what) == missing.end())
      missing.push_back(what);
    if (mark == status::Mark::kFault && faults++ == 0) first = fmt::format("{}: {}", what, words);
  }
  if (faults > 1) first += fmt::format(" And {} more.", faults - 1);
  if (faults > 0) return {first, kRed};
  if (!missing.empty()) return {fmt::format("missing: {}", fmt::join(missing, ", ")), kAmber};
  return {"nothing is missing", kGreen};
}

}  // namespace

std::string ClockText(Duration length) {
  const auto seconds = std::max(Duration{}, length) / 1s;
  return fmt::format("{}:{:02}:{:02}", std::min<std::int64_t>(seconds / 3600, 99), seconds / 60 % 60,
                     seconds % 60);
}

View Describe(const Moment& moment) {
  const board::ShowNow& now = moment.show_now.value;
  View view;
  view.time_of_day = moment.time_of_day;
  view.go = GoOf(moment);
  view.standby = WordsOf(moment.show.cue_list, now.cue_standby);
  view.active = WordsOf(moment.show.cue_list, now.cue_active);
  view.comes = ComesOf(moment);
  view.roles = RolesOf(moment);
  view.levels = LevelsOf(moment);
  view.fault = FaultOf(moment.status);
  AddAct(moment, view);
  AddMarks(moment, view);
  AddPlaying(moment, view);
  AddLips(moment, view);
  if (const float rate = moment.stage_status.value.frames_per_s; rate > 0)
    view.rate = fmt::format("{:.0f} pictures a second", rate);
  return view;
}

}  // namespace kaori::monitor
