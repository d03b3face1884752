// Devices that answer late or not at all: what blocks is not done all the time.
#include <sys/eventfd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/programs/input/input_service.h"
#include "firmware/wire/dial_box.h"
#include "tests/appliance/programs/input_lines_fixture.h"
#include "tests/drivers/service_manager.h"

namespace kaori::input {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

using ::testing::Contains;

using tests::kPatience;
using tests::WatchingManager;

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

TEST_F(SlowLines, AreNotTakenForAHang) {
  chip_.there = false;
  WatchingManager manager;
  Wait(milliseconds(1));
  EXPECT_THAT(manager.Beat(), Contains(kPatience)) << "as the chip is closed";
  Wait(milliseconds(1001));
  EXPECT_THAT(manager.Beat(), Contains(kPatience)) << "as it is opened";
}

// A dial box that is gone as soon as it is read.
class DyingDevice final : public ports::HidChannel {
 public:
  int pollable() const override { return -1; }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t>) override {
    return Fail(std::errc::no_such_device, "read 1-1");
  }
  Result<void> Write(std::span<const std::uint8_t>) override { return {}; }

 private:
  const ports::HidIdentity identity_{
      .port = "1-1",
      .name = "",
      .descriptor = {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()}};
};

// A device at its port that cannot be opened, and says so after a while.
class SlowBus final : public ports::HidBus {
 public:
  explicit SlowBus(ManualClock& clock) : clock_(clock) {}
  int pollable() const override { return readable_.get(); }
  Result<std::vector<std::string>> Ports() override { return std::vector<std::string>{"1-1"}; }
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string&) override {
    ++opened;
    clock_.Advance(answers_after);
    if (!opens) return Fail(std::errc::io_error, "open 1-1");
    return std::make_unique<DyingDevice>();
  }

  Duration answers_after{};
  bool opens = false;
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

TEST_F(SlowDevice, IsNotTakenForAHang) {
  WatchingManager manager;
  Play(milliseconds(10));
  EXPECT_THAT(manager.Beat(), Contains(kPatience)) << "as it is opened";
  bus_.opens = true;
  Play(milliseconds(250));
  EXPECT_EQ(bus_.opened, 2);
  const auto heard = manager.Beat();
  EXPECT_THAT(heard, Contains(kPatience)) << "as it is opened";
  EXPECT_THAT(heard, Contains("WATCHDOG=1").Times(::testing::Ge(2))) << "and as it is closed";
}

TEST(SlowDisk, IsNotTakenForAHang) {
  const board::BoardFile file;
  LearntTurns turns(file.folder() / "turns.toml");
  WatchingManager manager;
  EXPECT_TRUE(turns.Keep({.port = "1-1", .name = "box", .descriptor = {}}, 24));
  EXPECT_THAT(manager.Beat(), Contains(kPatience));
}

}  // namespace
}  // namespace kaori::input
