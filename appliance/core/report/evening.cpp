#include "appliance/core/report/evening.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "appliance/core/board/mouth.h"
#include "appliance/core/showlog/replay.h"

namespace kaori::report {
namespace {

using std::chrono::milliseconds;

constexpr Duration kStoodStill = milliseconds(500);  // A longer pause between two frames is told.
// A stamp that is older belongs to a control that has not moved since.
constexpr Duration kOldestMove = milliseconds(250);

// A device as people call it, and how it stood in one frame.
struct Source {
  const char* name;
  board::SourceState state;
};

// The devices that a person can pull out.
std::array<Source, 8> SourcesOf(const board::Snapshot& board) {
  return {{{"dial box", board.surface.source},
           {"left stick", board.sticks[0].source},
           {"right stick", board.sticks[1].source},
           {"keyboard", board.keys.source},
           {"pointer", board.pointer.source},
           {"GPIO lines", board.lines.source},
           {"lip camera", board.lips.source},
           {"microphone", board.voice.source}}};
}

// Watches one log as it plays.
// What differs from one frame to the next becomes an incident, a cue or a measurement. Borrows all four.
class Watcher {
 public:
  Watcher(const showlog::LogFile& log, const show::Show& show, Evening& evening,
          std::vector<double>& delays_ms, std::vector<double>& lips_ms)
      : log_(log), show_(show), evening_(evening), delays_ms_(delays_ms), lips_ms_(lips_ms) {}

  // Frames on both sides of a gap are not compared: what happened between them is not known. Nor is
  // the first frame of a log.
  void Look(const showlog::Replay& replay) {
    const Time at = replay.presented_at();
    if (replay.follows()) {
      Compare(replay, at);
      if (at - last_ > kStoodStill)
        Tell(at, fmt::format("the picture stood still for {:.1f} s", Seconds(at - last_)));
    } else if (known_) {
      Tell(at, fmt::format("the log goes on after {:.0f} s: the stage was started again, or a part is lost",
                           Seconds(at - last_)));
    }
    Remember(replay);
    last_ = at;
  }

 private:
  void Tell(Time at, std::string what) {
    evening_.incidents.push_back({at, log_.DayTimeText(at), std::move(what)});
  }

  // Counters wrap, and only their differences count. A device that was not there when the log began,
  // and comes, was not lost.
  void Compare(const showlog::Replay& replay, Time at) {
    const performance::State& state = replay.made().state;
    if (state.cue_run.active != active_ && state.cue_run.active >= 0) NotePlayed(replay, at);
    if (state.cue_run.refused != gos_refused_)
      evening_.refused.push_back({at, log_.DayTimeText(at), "GO within the guard, or after the last cue"});
    if (const std::uint32_t refused = state.calls_refused - calls_refused_; refused != 0)
      Tell(at, fmt::format("{} calls named what the show has not", refused));
    if (const std::uint32_t out = state.locked_out - locked_out_; out != 0)
      Tell(at, fmt::format("{} presses or calls were refused by the lock", out));
    if (state.locked != locked_)
      Tell(at, state.locked != 0 ? "the show was locked" : "the show was unlocked");
    if (const std::uint32_t lost = state.calls_lost - calls_lost_; lost != 0)
      Tell(at, fmt::format("{} calls came faster than the frames and are lost", lost));
    const board::LineCheck& check = replay.board().line_check.value;
    if (check.phase == board::LineCheckPhase::kEnded && check_phase_ == board::LineCheckPhase::kRunning)
      evening_.line_checks.push_back({at, log_.DayTimeText(at), board::SummaryOf(check)});
    if (check.phase != board::LineCheckPhase::kRunning) CompareSources(replay.board(), at);
    MeasureDelay(replay.board(), at);
  }

  // A line check gives nothing of the devices to the show, which is no loss of them.
  void CompareSources(const board::Snapshot& board, Time at) {
    const auto sources = SourcesOf(board);
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const bool live = sources[i].state == board::SourceState::kLive;
      const bool was = sources_[i].state == board::SourceState::kLive;
      if (live == was) continue;
      if (!live) lost_at_[i] = at;
      if (live && lost_at_[i] == Time{}) continue;  // Plugged in for the first time.
      Tell(at, live ? fmt::format("{} is back after {:.1f} s", sources[i].name, Seconds(at - lost_at_[i]))
                    : fmt::format("{} is lost", sources[i].name));
    }
  }

  // What was called in the same frame is what began the cue; a chain and a wait begin theirs without a call.
  void NotePlayed(const showlog::Replay& replay, Time at) {
    PlayedCue played{.cue = static_cast<std::size_t>(replay.made().state.cue_run.active),
                     .at = at,
                     .clock = log_.DayTimeText(at),
                     .by = "by itself",
                     .chain = true};
    if (played.cue >= show_.cue_list.cues.size()) return;
    const auto name = [&](const char* by) {
      played.by = by;
      played.chain = false;
    };
    if (!replay.events().presses().empty()) name("button or key");
    for (const board::Call& call : replay.events().calls()) {
      if (call.verb == board::CallVerb::kGoTo) name("jump");
      if (call.verb == board::CallVerb::kCue)
        name(call.source == board::CallSource::kFootSwitch ? "foot switch" : "page");
    }
    evening_.cues.push_back(std::move(played));
  }

  // The youngest control that has moved since the frame before.
  // Of controls only what a hand moves is measured. A picture of the lips counts when it is seen for the first time.
  void MeasureDelay(const board::Snapshot& board, Time at) {
    const std::array stamps{board.surface.at, board.sticks[0].at, board.sticks[1].at, board.keys.at};
    Time youngest{};
    for (std::size_t i = 0; i < stamps.size(); ++i)
      if (stamps[i] != stamps_[i]) youngest = std::max(youngest, stamps[i]);
    if (youngest != Time{} && at >= youngest && at - youngest < kOldestMove)
      delays_ms_.push_back(Seconds(at - youngest) * 1e3);
    const auto& lips = board.lips;
    const bool seen = lips.source == board::SourceState::kLive && board::IsUsable(lips.value);
    if (seen && lips.at != lips_at_ && at >= lips.at && at - lips.at < kOldestMove)
      lips_ms_.push_back(Seconds(at - lips.at) * 1e3);
  }

  void Remember(const showlog::Replay& replay) {
    const performance::State& state = replay.made().state;
    const board::Snapshot& board = replay.board();
    active_ = state.cue_run.active;
    gos_refused_ = state.cue_run.refused;
    calls_refused_ = state.calls_refused;
    calls_lost_ = state.calls_lost;
    locked_out_ = state.locked_out;
    locked_ = state.locked;
    check_phase_ = board.line_check.value.phase;
    if (check_phase_ != board::LineCheckPhase::kRunning) sources_ = SourcesOf(board);
    lips_at_ = board.lips.at;
    stamps_ = {board.surface.at, board.sticks[0].at, board.sticks[1].at, board.keys.at};
    known_ = true;
  }

  const showlog::LogFile& log_;
  const show::Show& show_;
  Evening& evening_;
  std::vector<double>&delays_ms_, &lips_ms_;
  bool known_ = false;
  Time last_{};
  std::int32_t active_ = -1;
  std::uint32_t gos_refused_ = 0, calls_refused_ = 0, calls_lost_ = 0, locked_out_ = 0;
  std::uint16_t locked_ = 0;
  std::array<Source, 8> sources_{};
  std::array<Time, 8> lost_at_{};
  board::LineCheckPhase check_phase_{};
  std::array<Time, 4> stamps_{};
  Time lips_at_{};
};

// Sorts the list. Both figures are values that were measured, not mixed with their neighbours.
Delays DelaysOf(std::vector<double>& ms) {
  if (ms.empty()) return {};
  std::ranges::sort(ms);
  return {ms[ms.size() / 2], ms[ms.size() * 99 / 100], ms.size()};
}

// An act is played from its first cue on; one that is played again later in the evening goes on.
std::vector<ActPlayed> ActsOf(const Evening& evening, const show::Show& show, Time end) {
  std::vector<ActPlayed> acts;
  Time begun{}, last{};
  for (const PlayedCue& played : evening.cues) {
    const std::string& act = ActOf(show, played.cue);
    if (acts.empty() || acts.back().act != act) {
      if (!acts.empty()) acts.back().until_next = played.at - last;
      acts.push_back({act, played.clock, {}, {}});
      begun = played.at;
    }
    last = played.at;
    acts.back().length = last - begun;
  }
  if (!acts.empty()) acts.back().until_next = end - last;
  return acts;
}

// `times` is not empty: a cue that nobody played has no entry.
Duration MedianOf(std::vector<Duration> times) {
  std::ranges::sort(times);
  const std::size_t half = times.size() / 2;
  return times.size() % 2 == 1 ? times[half] : (times[half - 1] + times[half]) / 2;
}

}  // namespace

// An empty text where neither this cue nor one before it names an act.
const std::string& ActOf(const show::Show& show, std::size_t cue) {
  static const std::string kNone;
  for (std::size_t i = cue + 1; i-- > 0;)
    if (!show.cue_list.cues[i].act.empty()) return show.cue_list.cues[i].act;
  return kNone;
}

// Each log has a watcher of its own, so that the last frame of one file and the first of the next are not
// compared. Delays of all files are one list.
Evening ReadEvening(std::span<const showlog::LogFile* const> logs, const show::Show& show) {
  Evening evening;
  std::vector<double> delays_ms, lips_ms;
  Time first{}, last{};
  for (const showlog::LogFile* log : logs) {
    showlog::Replay replay(*log, show);
    Watcher watcher(*log, show, evening, delays_ms, lips_ms);
    while (replay.Next()) {
      watcher.Look(replay);
      last = replay.presented_at();
      if (first == Time{}) first = last;
    }
    evening.frames += replay.frames();
    evening.frames_that_differ += replay.frames_that_differ();
    evening.faults.insert(evening.faults.end(), log->faults().begin(), log->faults().end());
    evening.faults.insert(evening.faults.end(), replay.faults().begin(), replay.faults().end());
  }
  evening.box = logs.front()->head().box;
  evening.day = logs.front()->Day();
  evening.begins = logs.front()->DayTimeText(first);
  evening.ends = logs.back()->DayTimeText(last);
  evening.length = last - first;
  evening.acts = ActsOf(evening, show, last);
  evening.hand_to_scanout = DelaysOf(delays_ms);
  evening.lips_to_scanout = DelaysOf(lips_ms);
  return evening;
}

std::vector<Evening> ReadEvenings(std::span<const showlog::LogFile> logs, const show::Show& show) {
  std::vector<Evening> evenings;
  for (std::size_t i = 0; i < logs.size();) {
    std::vector<const showlog::LogFile*> one;
    const showlog::LogHead& first = logs[i].head();
    for (; i < logs.size() && showlog::IsSameEvening(logs[i].head(), first); ++i) one.push_back(&logs[i]);
    evenings.push_back(ReadEvening(one, show));
  }
  return evenings;
}

// Of a cue that was played twice the first time counts, and so does the first beginning of its act.
std::map<std::size_t, Duration> TimesInActs(const Evening& evening, const show::Show& show) {
  std::map<std::size_t, Duration> times;
  std::map<std::string, Time> begun;
  for (const PlayedCue& played : evening.cues) {
    const Time act = begun.emplace(ActOf(show, played.cue), played.at).first->second;
    times.emplace(played.cue, played.at - act);
  }
  return times;
}

// An evening on which a cue was not played says nothing of that cue.
std::map<std::size_t, Duration> UsualTimes(std::span<const Evening> evenings, const show::Show& show) {
  std::map<std::size_t, std::vector<Duration>> all;
  for (const Evening& evening : evenings)
    for (const auto& [cue, time] : TimesInActs(evening, show)) all[cue].push_back(time);
  std::map<std::size_t, Duration> usual;
  for (auto& [cue, times] : all) usual[cue] = MedianOf(std::move(times));
  return usual;
}

}  // namespace kaori::report
