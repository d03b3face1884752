// The serial boxes of 1993 at a pseudo-terminal: what an operator does there stands on the board as that of the USB box does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "drivers/serial/serial_bus.h"
#include "hw-sim/links/serial/pty_port.h"
#include "tests/appliance/programs/input_fixture.h"
#include "tests/appliance/programs/input_turn_lesson.h"

namespace kaori::input {
namespace {

using board::SourceState;
using std::chrono::milliseconds;
using ::testing::HasSubstr;
using DialBoxKind = sim::SerialDialBox::Kind;

int Times(const std::string& text, std::string_view what) {
  int times = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++times;
  return times;
}

class SerialBox : public ::testing::TestWithParam<DialBoxKind> {
 protected:
  SerialBox() : board_(file_.Open()), box_(GetParam()), line_(path(), box_) { EXPECT_TRUE(line_.Plug()); }

  std::string path() const { return (file_.folder() / "dials-of-1993").string(); }
  void Start() {
    bus_ = serial::SerialBus::Open({.path = path(),
                                    .box = static_cast<decode::SerialBox>(GetParam()),
                                    .look_every = milliseconds(1)},
                                   clock_)
               .value();
    service_.emplace(board_, InputWriters::Acquire(board_).value(),
                     InputSources{.buses = {bus_.get()}, .lines = {}, .turns = file_.folder() / "turns.toml"},
                     InputSettings{}, clock_);
  }
  // In steps of a millisecond. The kernel passes a terminal's bytes on by itself, so that they are awaited in real time.
  void Play(Duration time) {
    for (Duration t{}; t < time; t += milliseconds(1)) {
      clock_.Advance(milliseconds(1));
      const bool came = line_.Pump(clock_.now()) > 0;
      if (!service_) continue;
      if (came || (service_->attached_devices() == 0 && ++steps_ % 25 == 0)) Await();
      service_->Step();
    }
  }
  // Until the line or, where no channel has it, the bus has something.
  void Await() {
    std::vector<pollfd> waits;
    for (const int fd : service_->pollables())
      if (service_->attached_devices() == 0 || fd != bus_->pollable()) waits.push_back({fd, POLLIN, 0});
    ::poll(waits.data(), waits.size(), 300);
  }
  void PlugIn() {
    Start();
    Play(milliseconds(1500));
    ASSERT_EQ(service_->attached_devices(), 1);
  }
  board::Stamped<board::Surface> Surface() const { return board_.Read<board::Surface>(); }

  board::BoardFile file_;
  board::Board board_;
  ManualClock clock_;
  sim::SerialDialBox box_;
  sim::PtyPort line_;
  std::unique_ptr<serial::SerialBus> bus_;
  std::optional<InputService> service_;
  int steps_ = 0;
};

INSTANTIATE_TEST_SUITE_P(All, SerialBox,
                         ::testing::Values(DialBoxKind::kSgi, DialBoxKind::kSpectragraphics,
                                           DialBoxKind::kDls80));

TEST_P(SerialBox, WhatOneTurnHasIsLearntFromATurnOfAHand) {
  PlugIn();
  const auto turn = [&](int counts) {
    const std::int32_t before = Surface().value.counts[4];
    for (; counts > 0; counts -= 20) {
      box_.Turn(4, std::min(counts, 20));
      Play(milliseconds(30));
    }
    return Surface().value.counts[4] - before;
  };
  turn(1);
  const std::int32_t turned = turn(198);
  EXPECT_EQ(turned, 198);
  TurnLesson lesson(board_);
  EXPECT_EQ(
      lesson.Keep(4, static_cast<std::uint32_t>(turned), clock_.now(), [this] { Play(milliseconds(5)); }),
      board::LearnCall::kTurnKept);
  EXPECT_EQ(turn(200), 256) << "a box of 200 counts, as VRPN says of the SN-921";
}

TEST_P(SerialBox, TurnsAndPushesReachTheBoardAndLampsTheBox) {
  RecordProperty("twin", "serial box " + std::to_string(static_cast<int>(GetParam())));
  PlugIn();
  // The first position of a box that tells positions is no turn, and counts after silence alone.
  for (const int dial : {0, 7}) {
    box_.Turn(dial, 1);
    Play(milliseconds(30));
  }
  const auto before = Surface().value.counts;
  box_.Turn(0, 128);
  box_.Turn(7, -256);
  box_.Push(31);
  Play(milliseconds(60));
  EXPECT_EQ(Surface().source, SourceState::kLive);
  EXPECT_EQ(Surface().value.counts[0] - before[0], 128);
  EXPECT_EQ(Surface().value.counts[7] - before[7], -256);
  if (GetParam() == DialBoxKind::kDls80) return;
  EXPECT_EQ(Surface().value.buttons_down, 0x80000000U);
  box_.Release(31);
  auto stage = board_.AcquireWriter<board::Lamps>().value();
  stage.Write({.lit = 0x80000005}, clock_.now(), SourceState::kLive);
  Play(milliseconds(30));
  EXPECT_EQ(Surface().value.buttons_down, 0U);
  EXPECT_EQ(Surface().value.pushes[31], 1U);
  EXPECT_EQ(box_.lamps(), 0x80000005U);
}

TEST_P(SerialBox, PulledItIsOneLineAndPluggedInAgainItGoesOn) {
  PlugIn();
  box_.Turn(2, 1);
  Play(milliseconds(20));
  box_.Turn(2, 40);
  Play(milliseconds(20));
  const auto counts = Surface().value.counts;
  ::testing::internal::CaptureStderr();
  line_.Unplug();
  Play(milliseconds(1500));
  EXPECT_EQ(Surface().source, SourceState::kStale);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(Times(said, "\n"), 1) << said;
  EXPECT_THAT(said, HasSubstr("dials-of-1993"));
  ASSERT_TRUE(line_.Plug());
  Play(milliseconds(1500));
  EXPECT_EQ(Surface().source, SourceState::kLive);
  EXPECT_EQ(Surface().value.counts, counts);
  box_.Turn(2, 1);
  Play(milliseconds(20));
  box_.Turn(2, 5);
  Play(milliseconds(20));
  EXPECT_THAT(Surface().value.counts[2] - counts[2], ::testing::AnyOf(5, 6));
}

TEST_P(SerialBox, TornBytesAreOneLineAndMoveNothing) {
  PlugIn();
  box_.Turn(1, 1);
  Play(milliseconds(20));
  const auto before = Surface().value.counts;
  ::testing::internal::CaptureStderr();
  for (int n = 0; n < 3; ++n) {
    line_.SendRaw(std::array<std::uint8_t, 2>{
        static_cast<std::uint8_t>(GetParam() == DialBoxKind::kDls80 ? 0x81 : 0x31), 0});
    Await();
    Play(milliseconds(20));
  }
  box_.Turn(1, 3);
  Play(milliseconds(30));
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(Times(said, "\n"), 1) << said;
  EXPECT_THAT(said, HasSubstr("a torn message on the serial line dials-of-1993"));
  EXPECT_EQ(Surface().value.counts[1] - before[1], 3);
}

TEST_P(SerialBox, ALineOfAnotherSpeedIsOneLine) {
  PlugIn();
  ::testing::internal::CaptureStderr();
  box_.set_baud(19200);
  for (int n = 0; n < 60; ++n) {
    box_.Turn(3, 7);
    Play(milliseconds(25));
  }
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(Times(said, "is no message of this kind of box: its speed or its kind is another"), 1) << said;
  EXPECT_EQ(Surface().source, SourceState::kStale);
}

using MuteBox = SerialBox;
INSTANTIATE_TEST_SUITE_P(Asked, MuteBox, ::testing::Values(DialBoxKind::kSgi, DialBoxKind::kSpectragraphics));

TEST_P(MuteBox, ABoxThatDoesNotAnswerIsOneLineAndIsFoundWhenItHasPower) {
  ::testing::internal::CaptureStderr();
  box_.set_mute(true);
  Start();
  Play(milliseconds(4000));
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(Times(said, "\n"), 1) << said;
  EXPECT_THAT(said, HasSubstr("whether it has power and its cable is right: Connection timed out"));
  box_.set_mute(false);
  Play(milliseconds(3000));
  EXPECT_EQ(service_->attached_devices(), 1);
}

// As by a second question that the box gets after it was started, or by its power that went and came.
TEST_P(MuteBox, ABoxThatBeganAnewIsStartedAnewAndPlays) {
  PlugIn();
  box_.Receive(std::array<std::uint8_t, 1>{0x20}, clock_.now());
  EXPECT_FALSE(box_.reports());
  Play(milliseconds(400));
  EXPECT_TRUE(box_.reports());
  // The first position of a box that tells positions is no turn.
  box_.Turn(4, 1);
  Play(milliseconds(30));
  const auto before = Surface().value.counts;
  box_.Turn(4, 9);
  Play(milliseconds(30));
  EXPECT_EQ(Surface().value.counts[4] - before[4], 9);
}

TEST(SerialOption, NamesTheKindsThatThereAre) {
  EXPECT_EQ(serial::ParseSerialBox("/dev/ttyUSB0=dls80", 200)->box, decode::SerialBox::kDls80);
  for (const char* wrong : {"/dev/ttyUSB0", "=sgi", "/dev/ttyUSB0=sn921"})
    EXPECT_THAT(serial::ParseSerialBox(wrong, 200).error().message(),
                HasSubstr("kinds are sgi, spectragraphics, dls80"));
}

}  // namespace
}  // namespace kaori::input
