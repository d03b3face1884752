#include "tests/benchmark/system_benchmark.h"

#include <poll.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <stdexcept>

#include "appliance/core/board/board.h"
#include "appliance/core/board/performance_state.h"
#include "appliance/core/performance/state.h"
#include "hw-sim/links/local/rig.h"
#include "tests/benchmark/figures.h"
#include "tests/system/program_runner.h"

namespace kaori::benchmark {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod = 33'333'333ns;  // The rate at which a machine without a GPU plays.
constexpr int kDial = 3;                    // The fade time: it changes nothing in the picture.

double Milliseconds(Duration d) {
  return Seconds(d) * 1e3;
}

// The system under measurement: devices in this process, programs in their own.
class SystemUnderTest {
 public:
  explicit SystemUnderTest(std::string pack) : pack_(std::move(pack)) {
    auto rig =
        sim::Rig::Open({.folder = system_.links(), .screen_period = kPeriod, .wakes_by_timer = true}, clock_);
    if (!rig) throw std::runtime_error(rig.error().message());
    rig_ = std::move(*rig);
    system_.Start("kaori-input", {"--board", system_.board(), "--links", system_.links()});
  }

  void StartStage() {
    system_.Start("kaori-stage", {"--board", system_.board(), "--pack", pack_, "--links", system_.links()});
  }
  // A program that does no more than EGL asks for, from its start to its first frame.
  Duration TimeBareEgl() {
    const Time begun = now();
    if (system_.RunToEnd("bare-egl", {}) != 0)
      throw std::runtime_error("bare-egl could not draw:\n" + system_.LogOf("bare-egl"));
    return now() - begun;
  }
  void KillStage() { system_.Kill("kaori-stage"); }
  int stage_pid() const { return system_.PidOf("kaori-stage"); }
  std::string board() const { return system_.board(); }
  Time now() const { return clock_.now(); }
  sim::Rig& rig() { return *rig_; }

  // Lets devices speak until `done`.
  template <class Done>
  void Until(Done done) {
    const Time late = now() + 30s;
    while (!done()) {
      if (now() > late)
        throw std::runtime_error("the system did not answer within 30 s:\n" + system_.LogOf("kaori-stage"));
      rig_->Pump();
      pollfd waiting{rig_->pollable(), POLLIN, 0};
      const timespec nap{
          0, 1'000'000};  // Rare looks: the programs need both cores, and times are read from the board.
      ::ppoll(&waiting, 1, &nap, nullptr);
    }
    rig_->Pump();
  }
  void Wait(Duration time) {
    const Time end = now() + time;
    Until([&] { return now() >= end; });
  }
  Duration TimeToNextFrame() {
    const Time begun = now();
    const auto before = rig_->screen().frames_shown();
    Until([&] { return rig_->screen().frames_shown() > before; });
    return now() - begun;
  }

 private:
  SteadyClock clock_;
  test::ProgramRunner system_;
  std::string pack_;
  std::unique_ptr<sim::Rig> rig_;
};

// One turn of a dial: from the report's arrival to the end of the frame that was drawn with it.
Duration OneReport(SystemUnderTest& system, const board::Board& board) {
  const auto counts = [&] { return board.Read<board::Surface>().value.counts[kDial]; };
  const auto before = counts();
  system.rig().dial_box().Turn(kDial, 0.01);
  system.Until([&] { return counts() != before; });
  const auto surface = board.Read<board::Surface>();
  std::uint32_t frames = 0;
  system.Until([&] {
    frames = board.Read<board::StageStatus>().value.frames;
    const auto state = board::Restore<performance::State>(board.Read<board::Performance>().value);
    return state && state->seen.dials[kDial] == surface.value.counts[kDial];
  });
  system.Until([&] { return board.Read<board::StageStatus>().value.frames > frames; });
  return board.Read<board::StageStatus>().at - surface.at;
}

std::vector<Metric> ReportToFrame(SystemUnderTest& system, bool quick) {
  const auto board = board::Board::Open(system.board());
  if (!board) throw std::runtime_error(board.error().message());
  std::mt19937 random(3);
  std::vector<double> ms;
  for (int i = 0; i < (quick ? 30 : 300); ++i) {
    // Anywhere within a refresh, for the end of the last trial is tied to one.
    system.Wait(std::chrono::milliseconds(40) + std::chrono::nanoseconds(random() % kPeriod.count()));
    ms.push_back(Milliseconds(OneReport(system, *board)));
  }
  std::vector<double> frames(ms);
  for (double& f : frames) f /= Milliseconds(kPeriod);
  return {Figure("report_to_frame.frames", "refreshes at 30 Hz", frames),
          Figure("report_to_frame.ms", "ms", ms)};
}

double ResidentMb(int pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
  return 0;
}

}  // namespace

std::vector<Metric> MeasureSystem(const std::string& pack, bool quick) {
  const int rounds = quick ? 3 : 12;
  SystemUnderTest system(pack);
  std::vector<double> start_ms, start_over_bare, restart_ms;
  for (int i = 0; i < rounds; ++i) {
    const double bare_ms = Milliseconds(system.TimeBareEgl());
    Time begun = system.now();
    system.StartStage();
    system.TimeToNextFrame();
    start_ms.push_back(Milliseconds(system.now() - begun));
    start_over_bare.push_back(start_ms.back() / bare_ms);
    system.Wait(300ms);
    begun = system.now();
    system.KillStage();
    system.StartStage();
    system.TimeToNextFrame();
    restart_ms.push_back(Milliseconds(system.now() - begun));
    system.Wait(300ms);
    if (i + 1 < rounds) system.KillStage();
  }
  std::vector<Metric> metrics{Figure("stage.start_ms", "ms", start_ms),
                              Figure("stage.start_over_bare_egl", "ratio", start_over_bare),
                              Figure("stage.restart_ms", "ms", restart_ms)};
  for (const Metric& metric : ReportToFrame(system, quick)) metrics.push_back(metric);
  metrics.push_back(Figure("memory.rss_mb", "MB", {ResidentMb(system.stage_pid())}));
  return metrics;
}

}  // namespace kaori::benchmark
