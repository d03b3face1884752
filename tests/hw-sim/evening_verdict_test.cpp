// Running orders as text, the actions between their lines, and the sums of several evenings.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "appliance/core/show/pack.h"
#include "hw-sim/evening/improvisation.h"
#include "hw-sim/evening/running_order.h"
#include "hw-sim/evening/verdict.h"
#include "hw-sim/scenario/reader.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;
using ::testing::IsEmpty;

class ARunningOrder : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { show_ = show::LoadPack(KAORI_PACK).value(); }
  static void TearDownTestSuite() { show_ = {}; }
  static inline show::Show show_;
};

TEST_F(ARunningOrder, OfTheEveningHasSixtyCuesAndFifteenFaultsInAHundredMinutes) {
  const auto order = LoadRunningOrder(KAORI_PLAYS "/evening.play", show_);
  ASSERT_TRUE(order) << order.error().message();
  EXPECT_GE(order->length, 100min);
  EXPECT_GE(order->faults.size(), 15U);
  const auto calls = std::ranges::count_if(order->expectations, [](const Expectation& one) {
    return !one.keep &&
           (one.condition.kind == Condition::Kind::kCue || one.condition.kind == Condition::Kind::kRefused);
  });
  EXPECT_GE(calls, 60);
  for (const show::Cue& cue : show_.cue_list.cues)
    EXPECT_TRUE(std::ranges::any_of(
        order->expectations,
        [&](const Expectation& one) { return one.condition.words == "cue " + cue.number; }))
        << "cue " << cue.number << " is never called";
  for (int i = 0; i < static_cast<int>(order->faults.size()); ++i)
    EXPECT_TRUE(
        std::ranges::any_of(order->expectations, [i](const Expectation& one) { return one.fault == i; }))
        << "nothing is expected of: " << order->faults[static_cast<std::size_t>(i)].name;
}

TEST_F(ARunningOrder, OfAFileWithoutALineIsRefused) {
  const auto file = std::filesystem::path(::testing::TempDir()) / ("no-lines-" + std::to_string(::getpid()));
  std::ofstream(file) << "\n# Nothing yet.\n";
  const auto order = LoadRunningOrder(file, show_);
  std::filesystem::remove(file);
  ASSERT_FALSE(order);
  EXPECT_EQ(order.error().message(), file.string() + ": nothing is done in it, and nothing is expected");
}

TEST_F(ARunningOrder, NamesEveryFaultyLine) {
  const RunningOrderRead read = ReadRunningOrder(
      "at 1s expect cue 99 within 1s\n"
      "at 1s expect cue 1\n"
      "at 1s expect cue 1 within 0s\n"
      "at 1s expect owner nose hand within 1s\n"
      "at 1s expect screen live within 1s\n"
      "expect cue 1 within 1s\n"
      "at 1s tear camera 3\n"
      "at 1s end world\n"
      "at 1s turn up the heating\n"
      "at 1s freeze 3s now\n"
      "at 1s line go tap\n",
      show_);
  EXPECT_EQ(Describe(read.problems, "a"),
            "a:1:18: the show has no cue 99\n"
            "a:2:19: expected within\n"
            "a:3:27: nothing is seen in no time\n"
            "a:4:20: no level \"nose\"\n"
            "a:5:14: \"screen\" is nothing that can be expected\n"
            "a:6:1: when? A line begins with its time, such as at 2.5s\n"
            "a:7:12: no HID device is called \"camera\"\n"
            "a:8:11: expected one of stage, input, lips\n"
            "a:9:7: unknown word \"turn\"; expected dial, push, hold, release, left, right, key, pointer, "
            "press, click, roll, lips, "
            "voice, say, lens, camera, microphone, loudspeaker, line, plug, unplug or scene\n"
            "a:10:17: nothing more is expected in this line");
}

TEST_F(ARunningOrder, IsShortenedToWhatIsOverByThen) {
  RunningOrderRead read = ReadRunningOrder(
      "at 1s line go tap\nat 1s expect cue 1 within 1s\nat 9s expect cue 1 within 2s\nat 11s line go tap\n"
      "at 11s fault \"late\"\nat 11s end stage\n",
      show_);
  EXPECT_THAT(read.problems, IsEmpty());
  Shorten(read.order, 10s);
  EXPECT_EQ(read.order.play.actions.size(), 2U) << "one tap";
  EXPECT_EQ(read.order.expectations.size(), 1U);
  EXPECT_THAT(read.order.faults, IsEmpty());
  EXPECT_THAT(read.order.incidents, IsEmpty());
}

TEST_F(ARunningOrder, HasTheSameActionsForTheSameSeedAndOthersForAnother) {
  const auto order = LoadRunningOrder(KAORI_PLAYS "/evening.play", show_).value();
  const auto actions = ImprovisedActions(order, 7);
  EXPECT_EQ(actions, ImprovisedActions(order, 7));
  EXPECT_NE(actions, ImprovisedActions(order, 8));
  for (const DevicePort port : {DevicePort::kStickLeft, DevicePort::kStickRight, DevicePort::kDialBox,
                                DevicePort::kCamera, DevicePort::kMicrophone})
    EXPECT_GT(
        std::ranges::count_if(actions, [port](const TimedAction& one) { return one.action.port == port; }),
        300)
        << PortName(port);
}

TEST(AVerdict, IsOfAllEveningsTogether) {
  Verdict first;
  first.evenings = 1;
  first.minutes = 100;
  first.frames = 180000;
  first.cues = 70;
  first.go_sent = 60;
  first.go_played = 57;
  first.go_refused = 3;
  first.open_files_start = first.open_files_end = 40;
  for (int minute = 0; minute < 100; ++minute) first.memory.push_back({minute / 60.0, 1000});
  Verdict all;
  Add(first, all);
  Verdict second = first;
  second.wrong = {"something"};
  EXPECT_TRUE(IsGood(all));
  EXPECT_NEAR(MemorySlope_kb_per_h(all), 0, 1e-6);
  Add(second, all);
  EXPECT_EQ(all.cues, 140U);
  EXPECT_EQ(all.minutes, 200);
  EXPECT_FALSE(IsGood(all));
}

// Each bound by itself: a verdict that was good is bad by one figure.
TEST(AVerdict, IsBadByEachOfItsFigures) {
  Verdict good;
  good.evenings = 1;
  good.minutes = 100;
  good.frames = 180000;
  good.pictures = good.pictures_drawn = 1500;
  good.log_bytes = 30'000'000;
  good.log_parts_lost = good.log_parts_allowed = 2;
  EXPECT_THAT(WhatIsWrong(good), IsEmpty());
  const auto wrong = [&good](std::uint64_t Verdict::*figure, std::uint64_t value) {
    Verdict bad = good;
    bad.*figure = value;
    return WhatIsWrong(bad);
  };
  using ::testing::ElementsAre;
  EXPECT_THAT(wrong(&Verdict::missed_cues, 1), ElementsAre("1 cues were missed"));
  EXPECT_THAT(wrong(&Verdict::unanswered_faults, 1), ElementsAre("1 faults were not answered"));
  EXPECT_THAT(wrong(&Verdict::replay_bits_differ, 1),
              ElementsAre("1 frames show something else when they play again"));
  EXPECT_THAT(wrong(&Verdict::frames, 0), ElementsAre("the log has no frame that could play again"));
  EXPECT_THAT(wrong(&Verdict::pictures, 0),
              ElementsAre("1500 pictures were drawn, and the log has 0 of them"));
  EXPECT_THAT(wrong(&Verdict::wrong_pictures, 1), ElementsAre("1 pictures are wrong"));
  EXPECT_THAT(wrong(&Verdict::frame_path_allocations, 1), ElementsAre("frames allocated memory 1 times"));
  EXPECT_THAT(wrong(&Verdict::log_parts_lost, 3), ElementsAre("3 parts of the log are lost, and 2 may be"));
  EXPECT_THAT(wrong(&Verdict::log_bytes, 30'100'000), ElementsAre("the log takes 301 KB a minute"));
}

TEST(AVerdict, OfWholeEveningsIsBadWhereTheyAreShortOrHaveFewCuesOrFaults) {
  Verdict good;
  good.evenings = 2;
  good.minutes = 200;
  good.frames = 360000;
  good.cues = 120;
  good.faults = 30;
  good.whole = true;
  EXPECT_THAT(WhatIsWrong(good), IsEmpty());
  Verdict bad = good;
  bad.minutes = 199;
  bad.cues = 119;
  bad.faults = 29;
  using ::testing::ElementsAre;
  EXPECT_THAT(WhatIsWrong(bad), ElementsAre("2 evenings have 199 minutes", "2 evenings have 119 cues",
                                            "2 evenings have 29 faults"));
  bad.whole = false;
  EXPECT_THAT(WhatIsWrong(bad), IsEmpty()) << "only a part was played";
}

TEST(AVerdict, IsBadWhereMemoryGrowsOrAFileStaysOpen) {
  Verdict verdict;
  verdict.evenings = 1;
  verdict.minutes = 100;
  verdict.frames = 180000;
  for (int minute = 0; minute < 100; ++minute)
    verdict.memory.push_back({minute / 60.0, 1000 + minute + (minute < 10 ? 500.0 * minute : 5000)});
  EXPECT_NEAR(MemorySlope_kb_per_h(verdict), 60, 1e-6) << "the first ten minutes do not count";
  EXPECT_TRUE(IsGood(verdict));
  for (MemoryAt& at : verdict.memory) at.resident_kb += 5 * at.hours;
  EXPECT_FALSE(IsGood(verdict));
  verdict.minutes = 50;
  verdict.memory.resize(50);
  EXPECT_TRUE(IsGood(verdict)) << "half an evening is too short to tell growth from what an act brings";
  verdict.memory.clear();
  verdict.open_files_end = 1;
  EXPECT_FALSE(IsGood(verdict));
}

}  // namespace
}  // namespace kaori::sim
