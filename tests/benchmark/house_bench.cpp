#include "tests/benchmark/house_bench.h"

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
#include "tests/system/house.h"

namespace kaori::benchmark {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod = 33'333'333ns;  // The rate at which a machine without a GPU plays.
constexpr int kDial = 3;  // The fade time: it changes nothing in the picture.

double Milliseconds(Duration d) {
  return Seconds(d) * 1e3;
}

// The house under measurement: devices in this process, programs in their own.
class Bench {
 public:
  explicit Bench(std::string pack) : pack_(std::move(pack)) {
    auto rig =
        sim::Rig::Open({.folder = house_.links(), .screen_period = kPeriod, .wakes_by_timer = true}, clock_);
    if (!rig) throw std::runtime_error(rig.error().message());
    rig_ = std::move(*rig);
    house_.Start("kaori-input", {"--board", house_.board(), "--links", house_.links()});
  }

  void StartStage() {
    house_.Start("kaori-stage", {"--board", house_.board(), "--pack", pack_, "--links", house_.links()});
  }
  void KillStage() { house_.Kill("kaori-stage"); }
  int stage_pid() const { return house_.PidOf("kaori-stage"); }
  std::string board() const { return house_.board(); }
  Time now() const { return clock_.now(); }
  sim::Rig& rig() { return *rig_; }

  // Lets devices speak until `done`.
  template <class Done>
  void Until(Done done) {
    const Time late = now() + 30s;
    while (!done()) {
      if (now() > late)
        throw std::runtime_error("the house did not answer within 30 s:\n" + house_.LogOf("kaori-stage"));
      rig_->Pump();
      pollfd waiting{rig_->pollable(), POLLIN, 0};
      const timespec nap{0, 1'000'000};  // Rare looks: the programs need both cores, and times are read from the board.
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
  test::House house_;
  std::string pack_;
  std::unique_ptr<sim::Rig> rig_;
};

// One turn of a dial: from the report's arrival to the end of the frame that was drawn with it.
Duration OneReport(Bench& bench, const board::Board& board) {
  const auto counts = [&] { return board.Read<board::Surface>().value.counts[kDial]; };
  const auto before = counts();
  bench.rig().dial_box().Turn(kDial, 0.01);
  bench.Until([&] { return counts() != before; });
  const auto surface = board.Read<board::Surface>();
  std::uint32_t frames = 0;
  bench.Until([&] {
    frames = board.Read<board::StageStatus>().value.frames;
    const auto state = board::Restore<performance::State>(board.Read<board::Performance>().value);
    return state && state->seen.dials[kDial] == surface.value.counts[kDial];
  });
  bench.Until([&] { return board.Read<board::StageStatus>().value.frames > frames; });
  return board.Read<board::StageStatus>().at - surface.at;
}

std::vector<Metric> ReportToFrame(Bench& bench, bool quick) {
  const auto board = board::Board::Open(bench.board());
  if (!board) throw std::runtime_error(board.error().message());
  std::mt19937 random(3);
  std::vector<double> ms;
  for (int i = 0; i < (quick ? 30 : 300); ++i) {
    // Anywhere within a refresh, for the end of the last trial is tied to one.
    bench.Wait(std::chrono::milliseconds(40) + std::chrono::nanoseconds(random() % kPeriod.count()));
    ms.push_back(Milliseconds(OneReport(bench, *board)));
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

std::vector<Metric> MeasureHouse(const std::string& pack, bool quick) {
  const int rounds = quick ? 3 : 12;
  Bench bench(pack);
  std::vector<double> start_ms, restart_ms;
  for (int i = 0; i < rounds; ++i) {
    Time begun = bench.now();
    bench.StartStage();
    bench.TimeToNextFrame();
    start_ms.push_back(Milliseconds(bench.now() - begun));
    bench.Wait(300ms);
    begun = bench.now();
    bench.KillStage();
    bench.StartStage();
    bench.TimeToNextFrame();
    restart_ms.push_back(Milliseconds(bench.now() - begun));
    bench.Wait(300ms);
    if (i + 1 < rounds) bench.KillStage();
  }
  std::vector<Metric> metrics{Figure("stage.start_ms", "ms", start_ms),
                              Figure("stage.restart_ms", "ms", restart_ms)};
  for (const Metric& metric : ReportToFrame(bench, quick)) metrics.push_back(metric);
  metrics.push_back(Figure("memory.rss_mb", "MB", {ResidentMb(bench.stage_pid())}));
  return metrics;
}

}  // namespace kaori::benchmark
