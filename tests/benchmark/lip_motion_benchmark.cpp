#include <poll.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <random>
#include <stdexcept>

#include "appliance/core/board/board.h"
#include "hw-sim/links/local/rig.h"
#include "tests/benchmark/figures.h"
#include "tests/benchmark/lips_benchmark.h"
#include "tests/system/program_runner.h"

namespace kaori::benchmark {
namespace {

using namespace std::chrono_literals;

constexpr double kShut = 0.25;
constexpr double kOpen = 0.75;
constexpr float kMoved = 0.05F;  // Of the mouth's width: more than it trembles by, less than its first step.

// The simulated camera in this process, kaori-lips in its own.
class LipSystem {
 public:
  explicit LipSystem(Duration period) : period_(period) {
    auto rig =
        sim::Rig::Open({.folder = system_.links(), .camera_period = period, .wakes_by_timer = true}, clock_);
    if (!rig) throw std::runtime_error(rig.error().message());
    rig_ = std::move(*rig);
    system_.Start("kaori-lips", {"--board", system_.board(), "--links", system_.links()});
    rig_->camera().SetMouth(kShut, 1);
    Until([&] { return std::filesystem::exists(system_.board()); });
    auto board = board::Board::Open(system_.board());
    if (!board) throw std::runtime_error(board.error().message());
    board_.emplace(std::move(*board));
    Until([&] { return lips().rest_width > 0; });
  }

  // Lips that were still open or shut at once, anywhere within a frame.
  Duration OneMotion() {
    Wait(250ms + std::chrono::nanoseconds(random_() % static_cast<std::uint64_t>(period_.count())));
    const float before = lips().height;
    open_ = !open_;
    const Time moved = clock_.now();
    rig_->camera().SetMouth(open_ ? kOpen : kShut, 1);
    Until([&] { return std::abs(lips().height - before) > kMoved; });
    return clock_.now() - moved;
  }

 private:
  board::Lips lips() const { return board_->Read<board::Lips>().value; }

  template <class Done>
  void Until(Done done) {
    const Time late = clock_.now() + 30s;
    while (!done()) {
      if (clock_.now() > late)
        throw std::runtime_error("kaori-lips is silent:\n" + system_.LogOf("kaori-lips"));
      rig_->Pump();
      pollfd waiting{rig_->pollable(), POLLIN, 0};
      const timespec nap{0, 100'000};
      ::ppoll(&waiting, 1, &nap, nullptr);
    }
  }
  void Wait(Duration time) {
    const Time end = clock_.now() + time;
    Until([&] { return clock_.now() >= end; });
  }

  Duration period_;
  SteadyClock clock_;
  test::ProgramRunner system_;
  std::unique_ptr<sim::Rig> rig_;
  std::optional<board::Board> board_;
  std::mt19937 random_{3};
  bool open_ = false;
};

Metric MeasureRate(const std::string& name, Duration period, bool quick) {
  LipSystem system(period);
  std::vector<double> ms(quick ? 15 : 60);
  for (double& one : ms) one = Seconds(system.OneMotion()) * 1e3;
  return Figure(name, "ms", ms);
}

}  // namespace

std::vector<Metric> MeasureLipMotion(bool quick) {
  return {MeasureRate("lips.motion_to_board_ms", 33'333'333ns, quick),
          MeasureRate("lips.motion_to_board_60_ms", 16'666'667ns, quick)};
}

}  // namespace kaori::benchmark
