// The line check: what it looks at, and what it says of each control.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include <fmt/format.h>

#include "tests/appliance/core/linecheck_fixture.h"

namespace kaori::linecheck {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

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
    board_.lines.value.active = way > 0 ? 0b111111 : 0b0100;
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
