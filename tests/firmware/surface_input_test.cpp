// The core of the control surfaces against operators whose every movement is known.
#include <gtest/gtest.h>

#include <vector>

#include "firmware/surface/axis.h"
#include "firmware/surface/button_log.h"
#include "firmware/surface/buttons.h"
#include "firmware/surface/dial_box.h"
#include "firmware/surface/dials.h"
#include "firmware/surface/lamps.h"
#include "tests/firmware/figures.h"
#include "tests/firmware/proof/ideal_hand.h"
#include "tests/firmware/proof/proofs.h"

namespace kaori::surface {
namespace {

using proof::Effort;
using proof::Figure;

constexpr std::uint64_t kEdges = 10'000'000;
constexpr std::uint32_t kButton = 0x40;

TEST(Dials, LoseNoneOfTenMillionEdgesAndTellEveryDoubleStep) {
  const auto proof = proof::ProveDials(kEdges * Effort(), 1);
  EXPECT_GE(proof.edges, kEdges);
  EXPECT_EQ(proof.counts_lost, 0u);
  EXPECT_EQ(proof.double_steps_untold, 0u);
  Figure("edges_tested", proof.edges);
  Figure("counts_lost", proof.counts_lost);
  Figure("double_steps_untold", proof.double_steps_untold);
}

TEST(Dials, ClockwiseIsPositiveAndTheFirstLookMovesNothing) {
  Dials dials;
  dials.Look(0x0003);
  EXPECT_EQ(dials.position(0), 0u);
  for (const DialLines lines : std::vector<DialLines>{2, 0, 1, 3}) dials.Look(lines);
  EXPECT_EQ(dials.position(0), 4u);
  for (const DialLines lines : std::vector<DialLines>{1, 0}) dials.Look(lines);
  EXPECT_EQ(dials.position(0), 2u);
}

TEST(Dials, AContactThatChattersOnOneLineGoesNowhere) {
  Dials dials;
  dials.Look(0);
  for (int n = 0; n < 1001; ++n) dials.Look(n % 2 == 0 ? 0x4000 : 0);
  EXPECT_EQ(dials.position(7), 1u);
  dials.Look(0);
  EXPECT_EQ(dials.position(7), 0u);
  EXPECT_EQ(dials.double_steps(), 0u);
}

TEST(Buttons, TellEveryPressOnceWhateverTheSwitchDoes) {
  // None, 200 us and 2 ms of bouncing at 4000 looks a second.
  for (const std::uint32_t bouncing_looks : {0u, 1u, 8u}) {
    const auto proof = proof::ProveButtons(20'000 * Effort(), bouncing_looks, 2);
    EXPECT_EQ(proof.wrong, 0u) << bouncing_looks;
    EXPECT_LE(proof.longest_press_looks, bouncing_looks + Buttons::kLooksToPress);
    EXPECT_LE(proof.longest_release_looks, bouncing_looks + Buttons::kLooksToRelease);
  }
}

TEST(Buttons, ArePressedAtTheThirdLookAndReleasedAtTheTwentieth) {
  Buttons buttons;
  EXPECT_EQ(buttons.Look(kButton), 0u);
  EXPECT_EQ(buttons.Look(kButton), 0u);
  EXPECT_EQ(buttons.Look(kButton), kButton);
  for (int look = 1; look < 20; ++look) EXPECT_EQ(buttons.Look(0), kButton) << look;
  EXPECT_EQ(buttons.Look(0), 0u);
}

TEST(ButtonLog, APressBetweenTwoPollsGetsBothItsReportsAndAChordShares) {
  ButtonLog log;
  log.Note(1, true);
  log.Note(0, true);
  EXPECT_EQ(log.Next(), 1u);
  EXPECT_EQ(log.Next(), 0u);
  EXPECT_TRUE(log.empty());
  log.Note(2, true);
  log.Note(6, true);
  EXPECT_EQ(log.Next(), 6u);
  EXPECT_TRUE(log.empty());
}

TEST(ButtonLog, NeverFillsAndEndsWithHowThingsStand) {
  ButtonLog log;
  for (int n = 0; n < 100'001; ++n) log.Note(n % 2 == 0 ? 5 : 0, true);
  std::size_t reports = 0;
  while (!log.empty()) log.Next(), ++reports;
  EXPECT_LE(reports, ButtonLog::kStates);
  EXPECT_EQ(log.told(), 5u);
}

TEST(Lamps, AreAsBrightAsTheyWereTold) {
  for (std::uint8_t brightness = 0; brightness <= Lamps::kBrightest; ++brightness) {
    Lamps lamps;
    lamps.set_lit(0x80000001);
    lamps.set_brightness(brightness);
    int ticks = 0;
    for (int n = 0; n < 15; ++n) ticks += lamps.Tick() == 0x80000001 ? 1 : 0;
    EXPECT_EQ(ticks, brightness);
  }
}

TEST(Axes, RestAtExactlyZeroAndReachTheirEndsInTime) {
  const auto proof = proof::ProveAxes(200 * Effort(), 3);
  EXPECT_EQ(proof.wrong, 0u);
  EXPECT_EQ(proof.reports_at_rest, 0u);
  EXPECT_LE(proof.longest_ms, 8u);
}

TEST(Axes, AreTaughtByMovingThemFromStopToStop) {
  AxisTeacher teacher(8000 << 4);
  EXPECT_FALSE(IsValid(teacher.ends()));
  for (const std::uint32_t value : {8000u, 600u, 15000u, 8000u}) teacher.See(value << 4);
  EXPECT_TRUE(IsValid(teacher.ends()));
  EXPECT_EQ(AxisValue(600 << 4, teacher.ends()), -32767);
  EXPECT_EQ(AxisValue(8010 << 4, teacher.ends()), 0);
  EXPECT_EQ(AxisValue(15000 << 4, teacher.ends()), 32767);
}

TEST(ADialBox, TellsAHostWhatWasDoneHoweverItPolls) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const auto proof = proof::ProveReports(500'000 * Effort(), seed);
    EXPECT_GT(proof.reports, 1000u);
    EXPECT_EQ(proof.wrong, 0u) << seed;
  }
}

TEST(ADialBox, SplitsATurnThatDoesNotFitIntoOneReport) {
  DialBox box({}, nullptr);
  proof::DialHand hand;
  box.Look(hand.lines());
  for (int n = 0; n < 70'000; ++n) {
    hand.Turn(3, -1);
    box.Look(hand.lines());
  }
  std::vector<int> turns;
  while (box.has_news()) turns.push_back(box.NextReport().value().turned[3]);
  EXPECT_EQ(turns, (std::vector<int>{-32768, -32768, -70'000 + 65'536}));
}

TEST(ADialBox, IsSilentWhereADialTremblesOnItsPlace) {
  DialBox box({}, nullptr);
  box.Look(0);
  box.Look(1);
  box.Look(0);
  EXPECT_FALSE(box.NextReport());
  EXPECT_FALSE(box.has_news());
}

TEST(ADialBox, IsDarkTwoSecondsAfterItsHostWentAndAtOnceWhereItSleeps) {
  DialBox box({}, nullptr);
  EXPECT_TRUE(box.Accept(ReportKind::kOutput, wire::EncodeLamps(0xF0)));
  EXPECT_EQ(box.Tick(0), 0u) << "nobody is there yet";
  box.SetHost(Host::kThere);
  EXPECT_EQ(box.Tick(0), 0xF0u);
  box.SetHost(Host::kAsleep);
  EXPECT_EQ(box.Tick(0), 0u);
  box.SetHost(Host::kThere);
  box.SetHost(Host::kGone);
  for (std::uint32_t tick = 1; tick < 2 * DialBox::kTicksPerSecond; ++tick)
    ASSERT_EQ(box.Tick(0), 0xF0u) << tick;
  EXPECT_EQ(box.Tick(0), 0u);
}

}  // namespace
}  // namespace kaori::surface
