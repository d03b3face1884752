// The line check of what is pushed and let go beside the dial box: buttons of sticks, and lines that call something.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/appliance/core/linecheck_fixture.h"

namespace kaori::linecheck {
namespace {

using ::testing::HasSubstr;

TEST_F(LineCheckTest, TicksButtonsOfSticksThatCallSomethingAndNamesTheirDevice) {
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

}  // namespace
}  // namespace kaori::linecheck
