// Calls on the board: of all writers in the order of time, with arguments, none handled twice, none lost without a count.
#include "tests/appliance/core/cues_fixture.h"

namespace kaori::performance {
namespace {

using board::CallVerb;
using board::CallWriter;
using board::CueKey;

class BoardCallsTest : public CuesTest {
 protected:
  void Make(CallVerb verb, std::uint32_t subject, CallWriter writer = CallWriter::kControl, Time at = {}) {
    CuesTest::Make({.at = at, .verb = verb, .subject = subject}, writer);
  }
  void MakeCue(CueVerb verb, CallWriter writer, Time at) {
    Make(CallVerb::kCue, static_cast<std::uint32_t>(verb), writer, at);
  }
};

TEST_F(BoardCallsTest, GoToACueStandsWhereARunThroughStandsToTheBit) {
  const Tracked wanted = RunThroughTo(6);
  Start();
  Make(CallVerb::kGoTo, CueKey("4"));
  Run(3s);
  EXPECT_TRUE(SameBits(wanted, Now()));
}

TEST_F(BoardCallsTest, StandByMovesWhatGoPlaysAndNothingElse) {
  Go();
  Run(2s);
  Make(CallVerb::kStandBy, CueKey("4"));
  Run(1s);
  EXPECT_EQ(run().standby, 5);
  EXPECT_EQ(run().active, 0);
  EXPECT_EQ(Face(), 1);
  Go();
  EXPECT_EQ(state_.scene, 2);
}

TEST_F(BoardCallsTest, ACueThatOthersBringStandsByWithThem) {
  Make(CallVerb::kStandBy, CueKey("3"));
  Step();
  EXPECT_EQ(run().standby, 2) << "2.5 continues to 2.10, which 3 follows";
}

TEST_F(BoardCallsTest, OfAllWritersAreHandledInTheOrderOfTime) {
  // All within one frame: stand by 4, GO, stand by 2.
  MakeCue(CueVerb::kGo, CallWriter::kInput, now_ + 2ms);
  Make(CallVerb::kStandBy, CueKey("4"), CallWriter::kControl, now_ + 1ms);
  Make(CallVerb::kStandBy, CueKey("2"), CallWriter::kControl, now_ + 3ms);
  Run(100ms);
  EXPECT_EQ(run().active, 5) << "GO played what stood by at its time";
  EXPECT_EQ(run().standby, 1) << "and the later call came after it";
}

TEST_F(BoardCallsTest, AreMergedWithKeysByTheirTimes) {
  Make(CallVerb::kStandBy, CueKey("4"), CallWriter::kControl, now_ - 1ms);
  Strike(kGo);
  Make(CallVerb::kStandBy, CueKey("1"), CallWriter::kControl, now_ + 1ms);
  Run(100ms);
  EXPECT_EQ(run().active, 5);
  EXPECT_EQ(run().standby, 0);
}

TEST_F(BoardCallsTest, AGoWithinTheGuardIsRefusedWhicheverWayItCame) {
  MakeCue(CueVerb::kGo, CallWriter::kControl, now_);
  Run(100ms);
  MakeCue(CueVerb::kGo, CallWriter::kInput, now_);
  Strike(kGo);
  Run(100ms);
  EXPECT_EQ(run().standby, 1);
  EXPECT_EQ(run().refused, 2U);
}

TEST_F(BoardCallsTest, WhatTheShowHasNotIsRefusedAndCounted) {
  Make(CallVerb::kGoTo, CueKey("99"));
  Make(CallVerb::kStandBy, CueKey(""));
  Make(CallVerb::kCue, 77);
  Make(CallVerb::kLevel, static_cast<std::uint32_t>(show::Level::kMix1));
  Step();
  EXPECT_EQ(state_.calls_refused, 4U);
  EXPECT_EQ(run().standby, 0);
}

TEST_F(BoardCallsTest, MoreThanALogKeepsAreCountedAsLostAndTheNewestAreHandled) {
  for (int i = 0; i < 40; ++i) Make(CallVerb::kStandBy, CueKey(i < 39 ? "1" : "4"));
  Step();
  EXPECT_EQ(state_.calls_lost, 8U);
  EXPECT_EQ(run().standby, 5);
  Step();
  EXPECT_EQ(state_.calls_lost, 8U);
}

TEST_F(BoardCallsTest, FromBeforeTheShowOpenedAreOverAndThoseOfARestartAreHandledOnce) {
  MakeCue(CueVerb::kGo, CallWriter::kControl, now_);
  state_ = Opening(show_, board_, now_);
  Run(1s);
  EXPECT_EQ(run().active, -1);
  // The stage is away, and goes on with the state that it left.
  MakeCue(CueVerb::kGo, CallWriter::kControl, now_);
  now_ += 5s;
  Run(1s);
  EXPECT_EQ(run().active, 0);
}

TEST_F(BoardCallsTest, OfAnotherBoardAreNoneOfOurs) {
  board_.calls[0].value.count = board_.calls[1].value.count = 20;
  board_.calls[0].source = board_.calls[1].source = board::SourceState::kLive;
  ForgetCounters(state_.seen);
  Run(1s);
  EXPECT_EQ(run().active, -1);
  MakeCue(CueVerb::kGo, CallWriter::kControl, now_);
  Run(1s);
  EXPECT_EQ(run().active, 0);
}

TEST_F(BoardCallsTest, TheFirstOneOfAWriterAfterALostBoardIsHandled) {
  ForgetCounters(state_.seen);
  Run(1s);
  MakeCue(CueVerb::kGo, CallWriter::kControl, now_);
  Run(100ms);
  EXPECT_EQ(run().active, 0);
}

TEST_F(BoardCallsTest, OfAWriterThatCountsAnewOnAnotherBoardAreHandled) {
  MakeCue(CueVerb::kGo, CallWriter::kControl, now_);
  Run(1s);
  MakeCue(CueVerb::kGo, CallWriter::kControl, now_);
  Run(1s);
  ASSERT_EQ(run().active, 1);
  ForgetCounters(state_.seen);
  board_.calls[1] = {};
  Run(1s);
  Make(CallVerb::kStandBy, CueKey("4"));
  Run(100ms);
  EXPECT_EQ(run().standby, 5);
  EXPECT_EQ(run().active, 1);
}

TEST_F(BoardCallsTest, OnTheWayFromOneBoardToTheOtherAreHandledOnce) {
  MakeCue(CueVerb::kGo, CallWriter::kControl, now_);
  Run(1s);
  for (int frame = 0; frame < 60; ++frame) {
    ForgetCounters(state_.seen);
    if (frame == 20) MakeCue(CueVerb::kGo, CallWriter::kControl, now_);
    Step();
  }
  Run(1s);
  EXPECT_EQ(run().played, 2U);
  EXPECT_EQ(run().refused, 0U);
}

TEST(CueKey, IsOneForNumbersThatAreEqualAndAnotherForOthers) {
  EXPECT_EQ(CueKey("2.5"), CueKey("02.05"));
  EXPECT_EQ(CueKey("0.1"), CueKey("00.1"));
  for (const char* other : {"25", "2.50", "2", "5.2", "2.5.0"})
    EXPECT_NE(CueKey("2.5"), CueKey(other)) << other;
}

}  // namespace
}  // namespace kaori::performance
