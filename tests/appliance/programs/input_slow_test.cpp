// Devices that answer late or not at all: what blocks is not done all the time.
#include <sys/eventfd.h>

#include <gtest/gtest.h>

#include "appliance/programs/input/input_service.h"
#include "tests/appliance/programs/input_lines_fixture.h"

namespace kaori::input {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class SlowLines : public LinesFixture {};

TEST_F(SlowLines, AreOpenedSeldom) {
  chip_.there = false;
  chip_.answers_after = seconds(5);
  Wait(milliseconds(1));
  chip_.opened = 0;
  for (const Time end = clock_.now() + seconds(100); clock_.now() < end;) Wait(milliseconds(10));
  EXPECT_LE(chip_.opened, 2) << "each opening keeps all other input waiting";
}

TEST_F(SlowLines, AreBackWithinASecondWhereTheyAnswerAtOnce) {
  chip_.there = false;
  Wait(seconds(10));
  chip_.there = true;
  Wait(milliseconds(1010));
  EXPECT_EQ(Read().source, board::SourceState::kLive);
}

// A device at its port that cannot be opened, and says so after a while.
class SlowBus final : public ports::HidBus {
 public:
  explicit SlowBus(ManualClock& clock) : clock_(clock) {}
  int pollable() const override { return readable_.get(); }
  Result<std::vector<std::string>> Ports() override { return std::vector<std::string>{"1-1"}; }
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string&) override {
    ++opened;
    clock_.Advance(answers_after);
    return Fail(std::errc::io_error, "open 1-1");
  }

  Duration answers_after{};
  int opened = 0;

 private:
  ManualClock& clock_;
  UniqueFd readable_{::eventfd(1, EFD_CLOEXEC | EFD_NONBLOCK)};
};

class SlowDevice : public ::testing::Test {
 protected:
  void Play(Duration time) {
    for (const Time end = clock_.now() + time; clock_.now() < end;) {
      clock_.Advance(milliseconds(10));
      service_.Step();
    }
  }

  const board::BoardFile file_;
  const board::Board board_ = file_.Open();
  ManualClock clock_;
  SlowBus bus_{clock_};
  InputService service_{board_, InputWriters::Acquire(board_).value(),
                        InputSources{.buses = {&bus_}, .lines = {}}, InputSettings{}, clock_};
};

TEST_F(SlowDevice, IsOpenedSeldom) {
  bus_.answers_after = seconds(5);
  Play(seconds(100));
  EXPECT_LE(bus_.opened, 2) << "each opening keeps all other input waiting";
}

TEST_F(SlowDevice, IsOpenedFourTimesASecondWhereItAnswersAtOnce) {
  Play(seconds(10));
  EXPECT_GE(bus_.opened, 38);
  EXPECT_LE(bus_.opened, 41);
}

}  // namespace
}  // namespace kaori::input
