// The line check: what it looks at, and what it says of each control.
#include "appliance/core/linecheck/line_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/board/lines.h"
#include "appliance/core/linecheck/items.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::linecheck {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using board::CheckedItem;
using board::CheckedKind;
using board::CheckedState;
using board::SourceState;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::uint32_t kLeft = 0, kBox = 2;

class LineCheckTest : public ::testing::Test {
 protected:
  LineCheckTest() {
    show_.buttons = {};
    for (const std::size_t button : {0, 1, 2, 6}) show_.buttons[button] = {show::CallKind::kFace, 0};
    board_.surface = {{}, now_, SourceState::kLive};
    for (auto& stick : board_.sticks) stick = {{}, now_, SourceState::kLive};
    board_.keys = {{}, now_, SourceState::kLive};
    board_.lines = {{.active = 1U << unsigned(board::Line::kService)}, now_, SourceState::kLive};
    board_.lips = {{.height = 0.3F, .quality = 1}, now_, SourceState::kLive};
    board_.voice = {{}, now_, SourceState::kLive};
    sound_ = {{}, now_, SourceState::kLive};
  }

  void Begin() { check_.Begin(ItemsFor(show_, devices_, board_, 2), {board_, sound_, 3}, now_); }
  // `move` is called before each frame with the time since the first.
  template <class Move>
  void Run(Duration time, Move move) {
    for (Duration t{}; t < time; t += performance::kFrame) {
      now_ += performance::kFrame;
      ++board_.lips.value.frames;
      board_.voice.value.blocks += 2;
      move(Seconds(t));
      check_.Look({board_, sound_, screens_}, now_);
    }
  }
  void Run(Duration time) {
    Run(time, [](double) {});
  }
  const CheckedItem* Find(CheckedKind kind, std::uint32_t device, std::uint32_t number) const {
    for (const CheckedItem& item : board::ItemsOf(check_.result()))
      if (item.kind == kind && item.device == device && item.number == number) return &item;
    return nullptr;
  }
  CheckedState StateOf(CheckedKind kind, std::uint32_t number = 0, std::uint32_t device = 0) const {
    const CheckedItem* item = Find(kind, device, number);
    EXPECT_NE(item, nullptr);
    return item == nullptr ? CheckedState::kUnseen : item->state;
  }
  CheckedState Axis(show::Control control) const {
    return StateOf(CheckedKind::kAxis, static_cast<std::uint32_t>(control), kLeft);
  }
  // As a person does it in a second: to one end, over to the other, and back.
  static float ThereAndBack(double t) {
    return static_cast<float>(std::sin(2 * std::numbers::pi * std::min(t, 1.0)));
  }

  show::Show show_ = performance::SmallShow();
  std::vector<std::uint8_t> devices_{2, 0, 1};  // As the usual roles say.
  board::Snapshot board_;
  board::Stamped<board::Sound> sound_;
  std::uint32_t screens_ = 3;
  Time now_ = Time{} + 100s;
  LineCheck check_;
};

TEST_F(LineCheckTest, LooksAtAllThatTheShowUsesOnceAndAtNothingElse) {
  for (std::size_t i = 0; i < show_.roles.roles.size(); ++i)
    devices_[i] = static_cast<std::uint8_t>(show_.roles.roles[i].device);
  board_.lines.value.wired = 0b0101;
  Begin();
  EXPECT_NE(Find(CheckedKind::kAxis, kLeft, std::uint32_t(show::Control::kX)), nullptr);
  EXPECT_NE(Find(CheckedKind::kDial, kBox, 7), nullptr);
  EXPECT_NE(Find(CheckedKind::kButton, kBox, 6), nullptr);
  EXPECT_EQ(Find(CheckedKind::kButton, kBox, 3), nullptr) << "it calls nothing";
  EXPECT_NE(Find(CheckedKind::kSwitch, 0, 0), nullptr);
  EXPECT_EQ(Find(CheckedKind::kSwitch, 0, 1), nullptr) << "it is not wired";
  EXPECT_NE(Find(CheckedKind::kScreen, 0, 1), nullptr);
  const auto items = board::ItemsOf(check_.result());
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(items[i].kind == items[j].kind && items[i].device == items[j].device &&
                   items[i].number == items[j].number);
}

TEST_F(LineCheckTest, LeavesOutTheDeviceOfARoleThatNobodyPlays) {
  for (std::size_t i = 0; i < show_.roles.roles.size(); ++i) devices_[i] = performance::kNoDevice;
  Begin();
  EXPECT_EQ(Find(CheckedKind::kAxis, kLeft, std::uint32_t(show::Control::kX)), nullptr);
  EXPECT_EQ(Find(CheckedKind::kDial, kBox, 0), nullptr);
}

TEST_F(LineCheckTest, TicksAnAxisThatWasAtBothEndsWithItsRange) {
  Begin();
  Run(500ms);
  EXPECT_EQ(Axis(show::Control::kX), CheckedState::kUnseen);
  Run(1s, [&](double t) { board_.sticks[0].value.x = ThereAndBack(t); });
  EXPECT_EQ(Axis(show::Control::kX), CheckedState::kSeen);
  EXPECT_EQ(Axis(show::Control::kY), CheckedState::kUnseen);
  const CheckedItem* x = Find(CheckedKind::kAxis, kLeft, 0);
  EXPECT_NEAR(x->low, -1, 0.02);
  EXPECT_NEAR(x->high, 1, 0.02);
  EXPECT_EQ(x->low_first, 0U);
}

TEST_F(LineCheckTest, SaysWhichEndCameFirstSoThatAReversedAxisIsFound) {
  Begin();
  Run(1s, [&](double t) { board_.sticks[0].value.x = -ThereAndBack(t); });
  EXPECT_EQ(Find(CheckedKind::kAxis, kLeft, 0)->low_first, 1U);
  EXPECT_THAT(board::PhraseOf(*Find(CheckedKind::kAxis, kLeft, 0)), HasSubstr("lower end first"));
}

TEST_F(LineCheckTest, CallsAWayShortThatEndsTooEarly) {
  Begin();
  Run(1s, [&](double t) { board_.sticks[0].value.twist = std::max(-0.4F, ThereAndBack(t)); });
  EXPECT_EQ(Axis(show::Control::kTwist), CheckedState::kShort);
  EXPECT_EQ(board::PhraseOf(*Find(CheckedKind::kAxis, kLeft, 2)), "twist short way, -0.40 to 1.00");
}

TEST_F(LineCheckTest, TicksADialThatTurnedAQuarterEachWay) {
  Begin();
  Run(1s, [&](double t) { board_.surface.value.counts[4] = static_cast<int>(40 * ThereAndBack(t)); });
  EXPECT_EQ(StateOf(CheckedKind::kDial, 4, kBox), CheckedState::kShort);
  Run(1s, [&](double t) { board_.surface.value.counts[4] = static_cast<int>(80 * ThereAndBack(t)); });
  EXPECT_EQ(StateOf(CheckedKind::kDial, 4, kBox), CheckedState::kSeen);
}

TEST_F(LineCheckTest, CallsNoisyWhatJittersAndNotWhatAPersonMovesFast) {
  Begin();
  int frame = 0;
  Run(1s, [&](double) {
    board_.sticks[0].value.y = 0.02F * static_cast<float>(++frame / 3 % 2);
    board_.surface.value.counts[2] = frame / 4 % 2;
    board_.sticks[0].value.x =
        static_cast<float>(std::sin(frame * 0.6));  // Six times a second, from end to end.
  });
  EXPECT_EQ(Axis(show::Control::kY), CheckedState::kNoisy);
  EXPECT_EQ(StateOf(CheckedKind::kDial, 2, kBox), CheckedState::kNoisy) << "a dial between two of its steps";
  EXPECT_EQ(Axis(show::Control::kX), CheckedState::kSeen);
  Run(5s);
  EXPECT_EQ(Axis(show::Control::kY), CheckedState::kNoisy) << "whoever looks away still learns of it";
}

TEST_F(LineCheckTest, CallsAStickStuckThatRestsOffItsMiddle) {
  board_.sticks[0].value.y = 0.5F;
  Begin();
  Run(9s);
  EXPECT_EQ(Axis(show::Control::kY), CheckedState::kUnseen);
  Run(2s);
  EXPECT_EQ(Axis(show::Control::kY), CheckedState::kStuck);
  Run(1s, [&](double t) { board_.sticks[0].value.y = ThereAndBack(t); });
  EXPECT_EQ(Axis(show::Control::kY), CheckedState::kSeen);
}

TEST_F(LineCheckTest, TicksButtonsAndFindsThoseThatStayDownOrChatter) {
  Begin();
  Run(100ms, [&](double t) {
    if (t == 0) ++board_.surface.value.pushes[0];
  });
  EXPECT_EQ(StateOf(CheckedKind::kButton, 0, kBox), CheckedState::kSeen);
  EXPECT_EQ(StateOf(CheckedKind::kButton, 1, kBox), CheckedState::kUnseen);
  Run(400ms, [&](double) { ++board_.surface.value.pushes[1]; });
  EXPECT_EQ(StateOf(CheckedKind::kButton, 1, kBox), CheckedState::kNoisy);
  board_.surface.value.buttons_down = 1U << 2U;
  Run(11s);
  EXPECT_EQ(StateOf(CheckedKind::kButton, 2, kBox), CheckedState::kStuck);
}

TEST_F(LineCheckTest, TicksButtonsOfASticksThatCallSomethingAndNamesTheirDevice) {
  show_.stick_buttons[show::kStickButtonCount + 4] = {show::CallKind::kBlink, 0};
  Begin();
  constexpr std::uint32_t kRight = 1;
  ASSERT_NE(Find(CheckedKind::kButton, kRight, 4), nullptr);
  EXPECT_EQ(Find(CheckedKind::kButton, kRight, 3), nullptr) << "it calls nothing";
  EXPECT_THAT(board::SummaryOf(check_.result()), HasSubstr("right stick button 5 not yet seen"));
  Run(20ms);
  board::NotePress(board_.sticks[1].value, 4, now_);
  Run(1s);
  EXPECT_EQ(Find(CheckedKind::kButton, kRight, 4)->state, CheckedState::kSeen);
  board_.sticks[1].source = SourceState::kStale;
  Run(20ms);
  EXPECT_EQ(Find(CheckedKind::kButton, kRight, 4)->state, CheckedState::kMissing);
  EXPECT_EQ(std::popcount(check_.lamps(now_) & 1U << 4U), 0) << "a stick has no lamps";
}

TEST_F(LineCheckTest, CallsAPushButtonForPanicStuckAndNotASwitchThatStays) {
  Begin();
  board_.lines.value.active |= 1U << unsigned(board::Line::kPanic) | 1U << unsigned(board::Line::kBlackout);
  Run(11s);
  EXPECT_EQ(Find(CheckedKind::kSwitch, 0, unsigned(board::Line::kPanic))->state, CheckedState::kStuck);
  EXPECT_EQ(Find(CheckedKind::kSwitch, 0, unsigned(board::Line::kBlackout))->state, CheckedState::kSeen);
}

TEST_F(LineCheckTest, TicksSwitchesThatWereSwitchedOverAndTheServiceKeyWhichIsOn) {
  Begin();
  Run(100ms);
  EXPECT_EQ(StateOf(CheckedKind::kSwitch, unsigned(board::Line::kService)), CheckedState::kSeen);
  EXPECT_EQ(StateOf(CheckedKind::kSwitch, unsigned(board::Line::kBlackout)), CheckedState::kUnseen);
  board_.lines.value.active |= 1U << unsigned(board::Line::kBlackout);
  Run(20s);
  EXPECT_EQ(StateOf(CheckedKind::kSwitch, unsigned(board::Line::kBlackout)), CheckedState::kSeen)
      << "it stays where it is put, and is not stuck";
}

TEST_F(LineCheckTest, SeesLipsThatOpenAndShutAndACameraWhosePictureStands) {
  Begin();
  Run(1s, [&](double t) { board_.lips.value.height = 0.28F + 0.25F * std::abs(ThereAndBack(t)); });
  EXPECT_EQ(StateOf(CheckedKind::kCamera), CheckedState::kShort);
  Run(1s, [&](double t) { board_.lips.value.height = 0.28F + 0.57F * std::abs(ThereAndBack(t)); });
  EXPECT_EQ(StateOf(CheckedKind::kCamera), CheckedState::kSeen);
  Run(2s, [&](double) { --board_.lips.value.frames; });
  EXPECT_EQ(StateOf(CheckedKind::kCamera), CheckedState::kStuck);
}

TEST_F(LineCheckTest, HearsAVoiceInTheMicrophoneAndInTheLoudspeaker) {
  Begin();
  Run(1s);
  EXPECT_EQ(StateOf(CheckedKind::kMicrophone), CheckedState::kUnseen);
  Run(1s, [&](double t) { board_.voice.value.speaking = t < 0.5 ? 1 : 0; });
  EXPECT_EQ(StateOf(CheckedKind::kMicrophone), CheckedState::kSeen);
  EXPECT_EQ(StateOf(CheckedKind::kLoudspeaker), CheckedState::kSeen);
  Run(16s, [&](double) { board_.voice.value.speaking = 1; });
  EXPECT_EQ(StateOf(CheckedKind::kMicrophone), CheckedState::kNoisy) << "it is never quiet";
  sound_.value.xruns += 6;
  Run(100ms);
  EXPECT_EQ(StateOf(CheckedKind::kLoudspeaker), CheckedState::kNoisy) << "it runs dry";
}

TEST_F(LineCheckTest, NamesWhatIsUnpluggedAsLongAsItIs) {
  Begin();
  board_.sticks[0].source = SourceState::kStale;
  screens_ = 1;
  Run(100ms);
  EXPECT_EQ(Axis(show::Control::kX), CheckedState::kMissing);
  EXPECT_EQ(StateOf(CheckedKind::kScreen, 1), CheckedState::kMissing);
  EXPECT_EQ(StateOf(CheckedKind::kScreen, 0), CheckedState::kSeen);
  board_.sticks[0].source = SourceState::kLive;
  Run(100ms);
  EXPECT_EQ(Axis(show::Control::kX), CheckedState::kUnseen);
}

TEST_F(LineCheckTest, NamesADeviceThatIsGoneOnceAndNotEachOfItsControls) {
  board_.surface.source = SourceState::kAbsent;
  Begin();
  const std::string summary = board::SummaryOf(check_.result());
  EXPECT_THAT(summary, HasSubstr("; dial box not plugged in; left stick x not yet seen; "));
  EXPECT_THAT(summary, Not(HasSubstr("dials")));
  EXPECT_THAT(summary, Not(HasSubstr("lamps")));
  EXPECT_EQ(board::PhrasesOf(check_.result(), "dial box", false), "not plugged in");
}

TEST_F(LineCheckTest, LightsAllLampsInTurnAndThenThoseOfButtonsThatNobodyHasPushed) {
  Begin();
  std::uint32_t all = 0;
  Run(800ms - performance::kFrame, [&](double) {
    EXPECT_EQ(std::popcount(check_.lamps(now_)), 1);
    all |= check_.lamps(now_);
  });
  EXPECT_EQ(all, 0b1000111U);
  ++board_.surface.value.pushes[1];
  Run(100ms);
  EXPECT_EQ(check_.lamps(now_), 0b1000101U);
  EXPECT_EQ(StateOf(CheckedKind::kLamps, 0, kBox), CheckedState::kUnseen) << "the box cannot see them";
  check_.ConfirmLamps(now_);
  Run(100ms);
  EXPECT_EQ(StateOf(CheckedKind::kLamps, 0, kBox), CheckedState::kSeen);
}

TEST_F(LineCheckTest, SaysInOneLineWhatFailed) {
  Begin();
  Run(1s, [&](double t) {
    const float way = ThereAndBack(t);
    for (auto& stick : board_.sticks) {
      stick.value = {.x = way, .y = way, .twist = way, .slider = std::abs(way), .hat = t < 0.5 ? 0 : 4};
      if (t > 0.25 && t < 0.75) stick.value.hat = t < 0.5 ? 2 : 6;
    }
    board_.sticks[0].value.twist = std::max(-0.4F, way);
    for (auto& count : board_.surface.value.counts) count = static_cast<int>(100 * way);
    board_.lips.value.height = 0.28F + 0.57F * std::abs(way);
    board_.voice.value.speaking = t < 0.5 ? 1 : 0;
    board_.lines.value.active = way > 0 ? 0b1111 : 0b0100;
    if (t == 0) board::NotePress(board_.keys.value, 4, now_);
  });
  check_.ConfirmLamps(now_);
  Run(100ms);
  check_.End();
  const std::string summary = board::SummaryOf(check_.result());
  EXPECT_THAT(summary,
              HasSubstr(fmt::format("{} of {} work; ", check_.result().count - 5, check_.result().count)));
  EXPECT_THAT(summary, HasSubstr("left stick twist short way, -0.40 to 1.00"));
  EXPECT_THAT(summary, HasSubstr("buttons 1-3, 7 not yet seen"));
  EXPECT_THAT(summary, Not(HasSubstr("\n")));
}

}  // namespace
}  // namespace kaori::linecheck
