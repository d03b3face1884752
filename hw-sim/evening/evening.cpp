#include "hw-sim/evening/evening.h"

#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "appliance/programs/stage/show_log.h"
#include "hw-sim/evening/improvisation.h"
#include "hw-sim/evening/incidents.h"
#include "hw-sim/evening/log_check.h"
#include "hw-sim/evening/watcher.h"
#include "hw-sim/rehearsal/rehearsal.h"
#include "hw-sim/scenario/key_names.h"
#include "hw-sim/scenario/player.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

// The programs ask for no less often than 10 ms; most of an evening's time goes to looking whether a socket
// has something.
constexpr Duration kTick = 5ms;
constexpr Duration kLogPatience = 5s;  // Of real time, for the disk.
constexpr Duration kAfterTheEnd = 1s;  // For what is still due.
// The lip camera of the evening: its smallest usual size.
constexpr int kCameraWidth_px = 160, kCameraHeight_px = 120;

// The time is that of all threads of the process, as clock(3) has it, and does not count what others use.
double ProcessorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The second number of statm is the resident set, in pages (proc(5)); KB are of 1024 bytes.
double ResidentKb() {
  std::ifstream statm("/proc/self/statm");
  double all = 0, resident = 0;
  statm >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1024;
}

// Those of the whole process; the folder that is being listed is none of the evening's.
int OpenFiles() {
  std::error_code none;
  return static_cast<int>(
             std::distance(fs::directory_iterator("/proc/self/fd", none), fs::directory_iterator())) -
         1;
}

bool IsBlack(const stage::SmallImage& picture) {
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    if (i % 4 != 3 && picture.pixels[i] != 0) return false;  // The fourth byte is no colour.
  return true;
}

// The system of one evening while it plays.
class Evening {
 public:
  Evening(const RunningOrder& order, const EveningOptions& options, stage::Studio& studio,
          Rehearsal& rehearsal, stage::ShowLog& log)
      : order_(order),
        options_(options),
        studio_(studio),
        rehearsal_(rehearsal),
        log_(log),
        watcher_(order, studio.show(), options.file),
        incidents_(rehearsal, rehearsal.rig().clock(), log),
        player_(WithImprovisation(), rehearsal.rig(), rehearsal.began()) {}

  // The hooks borrow this object and are taken out again at the end, since the rig may outlive it.
  void Play() {
    rehearsal_.SetLog(&log_.recorder());
    rehearsal_.CallAfterFrames([this](const auto& state, const auto&, Time) { See(state); });
    rehearsal_.rig().Watch([this](const OperatorAction& action) { CountGo(action); });
    if (const auto begun = incidents_.Begin(); !begun) watcher_.Fail(0, kNoFault, begun.error().message());
    verdict_.open_files_start = OpenFiles();
    Duration second{};
    while (now() < order_.length + kAfterTheEnd) {
      rehearsal_.Step([this](Time at) { Perform(at); });
      watcher_.Look(now(), rehearsal_.board(), seen_);
      rehearsal_.rig().loudspeaker().DrainHeard();
      if (now() < second) continue;
      second += 1s;
      if (!EachSecond()) break;
    }
    verdict_.open_files_end = OpenFiles();
    rehearsal_.CallAfterFrames({});
    rehearsal_.rig().Watch({});
    rehearsal_.SetLog(nullptr);
  }

  // As it is now; the log is not looked at. A full disk loses each part of the log that is closed while it is
  // full.
  Verdict Report() const {
    Verdict verdict = verdict_;
    verdict.evenings = 1;
    Duration full_since{};
    verdict.minutes = Seconds(now()) / 60;
    verdict.go_refused = rehearsal_.board().Read<board::ShowNow>().value.gos_refused;
    for (const Incident& incident : order_.incidents) {
      if (incident.kind == Incident::Kind::kDiskFill) full_since = incident.at;
      if (incident.kind == Incident::Kind::kDiskFree)
        verdict.log_parts_allowed +=
            1 + static_cast<std::uint64_t>((incident.at - full_since) / showlog::kChunkTime);
    }
    watcher_.Report(now(), verdict);
    return verdict;
  }

  const ShownEvening& shown() const { return shown_; }

 private:
  // The time is simulated, and counts from the beginning of the evening.
  Duration now() const { return rehearsal_.now() - rehearsal_.began(); }

  // The order's own lines stay as they are; improvised actions are sorted in between by time.
  Scenario WithImprovisation() const {
    Scenario scenario = order_.play;
    if (options_.improvised) {
      const auto actions = ImprovisedActions(order_, options_.seed);
      scenario.actions.insert(scenario.actions.end(), actions.begin(), actions.end());
    }
    PutInOrder(scenario);
    return scenario;
  }

  // What was expected begins before what happens at the same moment.
  // Incidents come before the operators' actions of the same moment.
  void Perform(Time at) {
    watcher_.Begin(at - rehearsal_.began(), rehearsal_.board(), seen_);
    for (; next_ < order_.incidents.size() && order_.incidents[next_].at <= at - rehearsal_.began(); ++next_)
      if (const auto made = incidents_.Make(order_.incidents[next_]); !made)
        watcher_.Fail(order_.incidents[next_].line, kNoFault, made.error().message());
    player_.Perform(at);
  }

  // GOs are counted by the performance: two may be played within one frame.
  void See(const performance::State& state) {
    ++seen_.pictures;
    seen_.blackout = state.blackout;
    verdict_.go_played += state.cue_run.played - std::exchange(gos_played_, state.cue_run.played);
    shown_.last = state.last;
    if (!studio_.drew()) return;
    ++verdict_.pictures_drawn;
    const auto sum = SumOfPicture(studio_, small_);
    if (sum) shown_.pictures.push_back({state.last, *sum});
    if (sum && (state.blackout < 1 || IsBlack(small_))) return;
    ++verdict_.wrong_pictures;
    verdict_.wrong.push_back(fmt::format(
        "{:.1f} s: {}", Seconds(now()),
        sum ? "a picture of the blackout is not black" : "the picture that was drawn cannot be read"));
  }

  // The two controls by which operators call GO in an order. One whose cable is out calls nobody.
  void CountGo(const OperatorAction& action) {
    static const int enter = KeyNamed("enter").value_or(0);
    if (action.verb != Verb::kPush || !rehearsal_.rig().plugged(PortName(action.port))) return;
    const bool foot = action.port == DevicePort::kLines && action.index == 0;
    const bool key = action.port == DevicePort::kKeyboard && action.index == enter;
    if (foot || key) ++verdict_.go_sent;
  }

  // The log's thread has real time, of which there is less here than on a box: it is waited for. False:
  // somebody stops the evening.
  bool EachSecond() {
    const SteadyClock wall;
    for (const Time end = wall.now() + kLogPatience; !log_.recorder().handed().empty() && wall.now() < end;)
      std::this_thread::sleep_for(1ms);
    std::error_code none;
    if (const auto bytes = fs::file_size(log_.file(), none); !none) seen_.log_bytes = bytes;
    // Memory is sampled once a simulated minute.
    if (++seconds_ % 60 == 0) verdict_.memory.push_back({Seconds(now()) / 3600, ResidentKb()});
    if (!options_.tell || options_.tell(Report())) return true;
    verdict_.stopped = true;
    return false;
  }

  const RunningOrder& order_;
  const EveningOptions& options_;
  stage::Studio& studio_;
  Rehearsal& rehearsal_;
  stage::ShowLog& log_;
  Watcher watcher_;
  Incidents incidents_;
  Player player_;
  ShowSeen seen_;
  Verdict verdict_;
  ShownEvening shown_;
  stage::SmallImage small_;
  std::size_t next_ = 0;
  int seconds_ = 0;
  std::uint32_t gos_played_ = 0;  // By the performance, at the last look.
};

}  // namespace

// A GO of which nothing was seen is a missed cue, and so is one that nobody called.
// An evening that was stopped may have a GO on its way: it is not compared.
void CompareGos(Verdict& verdict) {
  const std::uint64_t answered = verdict.go_played + verdict.go_refused;
  if (verdict.go_sent == answered || verdict.stopped) return;
  verdict.missed_cues += verdict.go_sent > answered ? verdict.go_sent - answered : answered - verdict.go_sent;
  verdict.wrong.push_back(fmt::format("{} GOs were called, {} played and {} refused", verdict.go_sent,
                                      verdict.go_played, verdict.go_refused));
}

// The rehearsal is over before its log is played again: what it has in memory is free then.
Result<Verdict> PlayEvening(const RunningOrder& order, const EveningOptions& options, stage::Studio& studio) {
  const SteadyClock wall;
  const Time begun = wall.now();
  const double processor_begun_s = ProcessorSeconds();
  std::error_code none;
  fs::remove_all(options.folder, none);
  // The log has a folder of its own, since every file in it is played again.
  const fs::path logs = fs::path(options.folder) / "log";
  Verdict verdict;
  ShownEvening shown;
  {
    studio.DrawOneOf(options.draw_one_of);
    auto rehearsal = Rehearsal::Open({.folder = options.folder + "/box",
                                      .width_px = options.width_px,
                                      .height_px = options.height_px,
                                      .hz = options.hz,
                                      .camera_width_px = kCameraWidth_px,
                                      .camera_height_px = kCameraHeight_px,
                                      .tick = kTick},
                                     studio);
    if (!rehearsal) return tl::unexpected(rehearsal.error());
    auto log = stage::ShowLog::Open(logs, stage::HeadOfLog(0, {}, (*rehearsal)->now()));
    if (!log) return tl::unexpected(log.error());
    Evening evening(order, options, studio, **rehearsal, **log);
    evening.Play();
    (*log)->Finish();
    verdict = evening.Report();
    CompareGos(verdict);
    shown = evening.shown();
  }
  if (auto checked = CheckLogs(logs, shown, {options.width_px, options.height_px}, studio, verdict); !checked)
    return tl::unexpected(checked.error());
  // A full disk that loses nothing was not full: the fault itself is then wrong, and has tested nothing.
  if (verdict.log_parts_lost == 0 && verdict.log_parts_allowed != 0)
    verdict.wrong.emplace_back("the disk of the log was full, and no part of the log is lost");
  fs::remove_all(options.folder, none);
  verdict.seconds = Seconds(wall.now() - begun);
  verdict.processor_seconds = ProcessorSeconds() - processor_begun_s;
  return verdict;
}

}  // namespace kaori::sim
