// Dials on GPIO lines, at a simulated chip: their turns stand on the board, and what the chip dropped moves nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <deque>
#include <functional>
#include <utility>

#include "drivers/gpio/dial_bus.h"
#include "tests/appliance/programs/input_fixture.h"
#include "tests/appliance/programs/input_turn_lesson.h"

namespace kaori::input {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

// A chip with two dials, which keeps so many edges and drops those that come after, as the kernel does.
struct SimulatedChip {
  std::deque<decode::DialEdge> waiting{};
  std::size_t most = 1024;
  std::uint32_t levels = 0;
  std::uint32_t sequence = 0;
  bool unplugged = false;
  std::function<void()> after_levels{};  // Runs once, when the levels were read.
  std::array<int, 2> places{};

  void Turn(std::size_t dial, int counts, Time at) {
    for (; counts != 0; counts += counts < 0 ? 1 : -1) {
      places[dial] += counts < 0 ? -1 : 1;
      const unsigned quarter = static_cast<unsigned>(places[dial]) & 3U;
      const unsigned a = quarter == 1 || quarter == 2 ? 1 : 0, b = quarter >= 2 ? 1 : 0;
      const std::uint32_t now = (levels & ~(3U << 2 * dial)) | (a | b << 1U) << 2 * dial;
      const std::uint32_t changed = levels ^ now;
      levels = now;
      ++sequence;
      if (waiting.size() < most)
        waiting.push_back({.at = at,
                           .line = static_cast<std::uint32_t>(std::countr_zero(changed)),
                           .active = (now & changed) != 0,
                           .sequence = sequence});
    }
  }
};

class SimulatedLines final : public gpio::DialLines {
 public:
  explicit SimulatedLines(SimulatedChip& chip) : chip_(chip) {}
  int pollable() const override { return -1; }
  Result<decode::DialEdge> ReadEdge() override {
    if (chip_.unplugged) return Fail(std::errc::no_such_device, "read an edge of a dial");
    if (chip_.waiting.empty())
      return Fail(std::errc::resource_unavailable_try_again, "read an edge of a dial");
    const auto edge = chip_.waiting.front();
    chip_.waiting.pop_front();
    return edge;
  }
  Result<std::uint32_t> Levels() override {
    const std::uint32_t levels = chip_.levels;
    if (const auto act = std::exchange(chip_.after_levels, {})) act();
    return levels;
  }

 private:
  SimulatedChip& chip_;
};

class GpioDials : public ::testing::Test {
 protected:
  GpioDials() : board_(file_.Open()) {
    bus_ = gpio::DialBus::Open(
               [this]() -> Result<std::unique_ptr<gpio::DialLines>> {
                 if (chip_.unplugged) return Fail(std::errc::no_such_device, "open the GPIO chip");
                 return std::make_unique<SimulatedLines>(chip_);
               },
               clock_)
               .value();
    service_.emplace(board_, InputWriters::Acquire(board_).value(),
                     InputSources{.buses = {bus_.get()}, .lines = {}, .turns = file_.folder() / "turns.toml"},
                     InputSettings{}, clock_);
    Play(milliseconds(5));
  }
  void Play(Duration time) {
    for (Duration t{}; t < time; t += milliseconds(1)) {
      clock_.Advance(milliseconds(1));
      service_->Step();
    }
  }
  board::Stamped<board::Surface> Surface() const { return board_.Read<board::Surface>(); }

  board::BoardFile file_;
  board::Board board_;
  ManualClock clock_;
  SimulatedChip chip_;
  std::unique_ptr<gpio::DialBus> bus_;
  std::optional<InputService> service_;
};

TEST_F(GpioDials, TurnsReachTheBoard) {
  chip_.Turn(0, 256, clock_.now());
  chip_.Turn(1, -100, clock_.now());
  Play(milliseconds(5));
  EXPECT_EQ(Surface().source, board::SourceState::kLive);
  EXPECT_EQ(Surface().value.counts[0], 256);
  EXPECT_EQ(Surface().value.counts[1], -100);
}

TEST_F(GpioDials, AnEncoderOfTwentyFourStepsIsLearntFromOneTurn) {
  TurnLesson lesson(board_);
  chip_.Turn(1, 96, clock_.now());
  Play(milliseconds(5));
  EXPECT_EQ(lesson.Keep(1, 96, clock_.now(), [this] { Play(milliseconds(5)); }), board::LearnCall::kTurnKept);
  chip_.Turn(1, 48, clock_.now());
  chip_.Turn(0, -96, clock_.now());
  Play(milliseconds(5));
  EXPECT_EQ(Surface().value.counts[1], 96 + 128);
  EXPECT_EQ(Surface().value.counts[0], -256);
}

TEST_F(GpioDials, WhatTheChipDroppedMovesNothingAndIsSaidOnce) {
  ::testing::internal::CaptureStderr();
  chip_.most = 100;
  for (int n = 0; n < 3; ++n) {
    chip_.Turn(0, 150, clock_.now());
    Play(milliseconds(3));
    EXPECT_EQ(Surface().value.counts[0], 100) << "what waited behind a gap is older than the levels";
  }
  chip_.most = 1024;
  for (const int turn : {1, 7}) {
    chip_.Turn(0, turn, clock_.now());
    Play(milliseconds(3));
  }
  EXPECT_EQ(Surface().value.counts[0], 107) << "the first edge tells of the last gap";
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("the kernel dropped edges of the dials on GPIO lines; they moved nothing"));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

TEST_F(GpioDials, AnEdgeThatComesWhileTheLevelsAreReadCounts) {
  chip_.most = 100;
  chip_.Turn(0, 150, clock_.now());
  Play(milliseconds(3));
  chip_.most = 1024;
  chip_.after_levels = [this] {
    clock_.Advance(milliseconds(1));
    chip_.Turn(0, 1, clock_.now());
  };
  for (const int turn : {1, 5}) {
    chip_.Turn(0, turn, clock_.now());
    Play(milliseconds(3));
  }
  EXPECT_EQ(Surface().value.counts[0], 100 + 1 + 5);
}

TEST_F(GpioDials, AChipThatIsPulledIsWaitedFor) {
  chip_.Turn(0, 10, clock_.now());
  Play(milliseconds(3));
  chip_.unplugged = true;
  Play(milliseconds(3));
  EXPECT_EQ(Surface().source, board::SourceState::kStale);
  chip_.unplugged = false;
  chip_.sequence = 0;  // Linux numbers the edges of each request from 1.
  Play(milliseconds(600));
  chip_.Turn(0, 5, clock_.now());
  Play(milliseconds(3));
  EXPECT_EQ(Surface().value.counts[0], 15);
}

TEST(DialWiring, HasTwoLinesForEachDial) {
  EXPECT_EQ(gpio::ParseDialWiring("gpiochip0:4,5,6,7")->offsets, (std::vector<std::uint32_t>{4, 5, 6, 7}));
  for (const char* wrong :
       {"gpiochip0", ":1,2", "gpiochip0:1", "gpiochip0:1,1", "gpiochip0:1,x", "gpiochip0:"})
    EXPECT_THAT(gpio::ParseDialWiring(wrong).error().message(), HasSubstr("two lines for each dial"));
}

}  // namespace
}  // namespace kaori::input
