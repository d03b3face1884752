// What the operators did between two looks at the board: in the order of time, and used once.
#include <gmock/gmock.h>

#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint8_t kP = 0x10, kY = 0x1C,
                       kA = 0x04;  // Typed in this order, which is not that of their codes.

class EventsTest : public ::testing::Test {
 protected:
  EventsTest() {
    board_.surface.source = board_.keys.source = board_.lines.source = board::SourceState::kLive;
  }

  void Strike(std::uint8_t usage) { board::NotePress(board_.keys.value, usage, now_ += 1ms); }
  void Push(std::size_t button) { board::NotePress(board_.surface.value, button, now_ += 1ms); }
  // Keys as they are, buttons above 1000.
  std::vector<int> Codes() {
    std::vector<int> codes;
    for (const Press& press : ReadEvents(seen_, board_).presses())
      codes.push_back(press.IsKey() ? press.code : 1000 + press.code);
    return codes;
  }

  board::Snapshot board_;
  Time now_ = Time{} + 100s;
  SeenInput seen_;
};

TEST_F(EventsTest, StandInTheOrderOfTimeAndNotOfTheirCodes) {
  for (const std::uint8_t usage : {kP, kY, kA}) Strike(usage);
  EXPECT_THAT(Codes(), ElementsAre(kP, kY, kA));
  EXPECT_THAT(Codes(), IsEmpty()) << "each is told once";
}

TEST_F(EventsTest, OfButtonsAndKeysAreMergedByTheirTimes) {
  Push(7);
  Strike(kP);
  Push(3);
  Strike(kA);
  Strike(kP);
  EXPECT_THAT(Codes(), ElementsAre(1007, kP, 1003, kA, kP));
}

TEST_F(EventsTest, AreMergedWhereTheirMicrosecondsWrap) {
  now_ = Time{} + std::chrono::microseconds((1LL << 32) - 1500);
  Push(7);
  Strike(kP);
  Push(3);
  EXPECT_THAT(Codes(), ElementsAre(1007, kP, 1003));
}

TEST_F(EventsTest, KeepTheNewestOfMoreThanTheBoardHolds) {
  for (int i = 0; i < 40; ++i) Strike(static_cast<std::uint8_t>(i));
  const auto codes = Codes();
  ASSERT_EQ(codes.size(), board::PressLog::kKept);
  EXPECT_EQ(codes.front(), 8);
  EXPECT_EQ(codes.back(), 39);
}

TEST_F(EventsTest, SayWhetherShiftWasHeldWithEachKey) {
  auto& modifiers = board_.keys.value.down[0xE0 / 32];
  modifiers = 1U << 1U;  // The left Shift key.
  Strike(kP);
  modifiers = 1U;  // Control.
  Strike(kP);
  const auto events = ReadEvents(seen_, board_);
  EXPECT_TRUE(events.presses()[0].shift) << "though it was let go before anybody looked";
  EXPECT_FALSE(events.presses()[1].shift);
}

TEST_F(EventsTest, ThatOneConsumerTakesOutAreNotSeenByTheNext) {
  for (const std::uint8_t usage : {kP, kY, kP, kA}) Strike(usage);
  auto events = ReadEvents(seen_, board_);
  events.Consume([](const Press& press) { return press.code == kP; });
  ASSERT_EQ(events.presses().size(), 2U);
  EXPECT_EQ(events.presses()[0].code, kY);
  EXPECT_EQ(events.presses()[1].code, kA);
}

TEST_F(EventsTest, OfASectionThatIsAbsentAreNoneAndAreToldWhenItIsBack) {
  Strike(kP);
  board_.surface.value.counts[2] = 40;
  board_.surface.source = board_.keys.source = board::SourceState::kAbsent;
  EXPECT_THAT(Codes(), IsEmpty());
  board_.surface.source = board_.keys.source = board::SourceState::kLive;
  const auto events = ReadEvents(seen_, board_);
  EXPECT_EQ(events.presses().size(), 1U);
  EXPECT_EQ(events.turned[2], 40);
}

TEST_F(EventsTest, OnAnotherBoardBeginWithWhatItShowsFirst) {
  ForgetCounters(seen_);
  Strike(kP);
  Push(3);
  board_.surface.value.counts[2] = 40;
  board_.keys.source = board::SourceState::kAbsent;
  auto events = ReadEvents(seen_, board_);
  EXPECT_THAT(events.presses(), IsEmpty());
  EXPECT_EQ(events.turned[2], 0);
  board_.keys.source = board::SourceState::kLive;
  EXPECT_THAT(Codes(), IsEmpty()) << "the keys came later";
  Strike(kA);
  EXPECT_THAT(Codes(), ElementsAre(kA));
}

TEST_F(EventsTest, OfADialWrapWithItsCounter) {
  board_.surface.value.counts[0] = INT32_MAX;
  ReadEvents(seen_, board_);
  board_.surface.value.counts[0] = INT32_MIN + 4;
  EXPECT_EQ(ReadEvents(seen_, board_).turned[0], 5);
}

TEST_F(PerformanceTest, OfTwoFacesCalledWithinOneFrameTheLaterOneIsPlayed) {
  Push(3);
  Push(1);
  Step();
  EXPECT_EQ(state_.faces.to, 1);
}

}  // namespace
}  // namespace kaori::performance
