// Programs die at random; the others play on, and nothing that an audience sees changes.
#include <array>
#include <fstream>
#include <random>

#include <gmock/gmock.h>

#include "tests/system/programs_fixture.h"

namespace kaori::test {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

TEST_F(HeldControls, StayWhereTheyAreWhenProgramsAreKilledTwentyTimes) {
  StartBox();
  ASSERT_TRUE(Await([&] { return Between() && AllLive() && frames() > 0; }, std::chrono::seconds(30)))
      << programs_.LogOf("kaori-input") << programs_.LogOf("kaori-lips") << programs_.LogOf("kaori-stage");
  PlayControls();
  Hold(milliseconds(500));
  Pose pose;
  ASSERT_TRUE(Settle(pose));
  ASSERT_EQ(pose.counts[0], 77);
  const std::array<std::string, 3> programs{"kaori-input", "kaori-lips", "kaori-stage"};
  std::mt19937 random(1993);
  for (int round = 0; round < 20; ++round) {
    const std::string& victim = programs[random() % programs.size()];
    SCOPED_TRACE(victim + ", round " + std::to_string(round));
    programs_.Kill(victim);
    ASSERT_TRUE(Await([&] { return Between() && !Serves(victim); }));
    ExpectOthersRun(victim);
    Start(victim);
    const std::uint32_t frames_then = frames();
    const std::uint32_t lips_then = lip_frames();
    ASSERT_TRUE(HoldsUntil(pose, [&] {
      return Serves(victim) && frames() > frames_then && lip_frames() > lips_then;
    })) << programs_.LogOf(victim);
  }
}

class WholeBox : public Programs {
 protected:
  void WritePlay() {
    std::ofstream(programs_.File("input.play")) << "scene input\n"
                                                   "at 0.5s dial 1 turn 0.4\n"
                                                   "at 0.5s dial 3 turn -0.25\n"
                                                   "at 0.6s push 2\n";
  }

  bool Back(const std::string& program, std::uint32_t frames_then, std::uint32_t lips_then) const {
    return programs_.Runs(program) && AllLive() && frames() > frames_then && lip_frames() > lips_then;
  }
};

TEST_F(WholeBox, KeepsItsPoseWhenAnyProgramIsKilledTwentyTimes) {
  WritePlay();
  Start("kaori-sim", {"--play", programs_.File("input.play")});
  StartBox();
  ASSERT_TRUE(Await([&] { return AllLive() && frames() > 0; }, std::chrono::seconds(30)))
      << programs_.LogOf("kaori-sim") << programs_.LogOf("kaori-stage");
  ASSERT_TRUE(Await([&] { return board_.Read<board::Surface>().value.pushes[1] == 1; }));
  Hold(milliseconds(500));
  Pose pose;
  ASSERT_TRUE(Settle(pose));
  ASSERT_EQ(pose.counts[2], -64);
  const std::array<std::string, 4> programs{"kaori-sim", "kaori-input", "kaori-lips", "kaori-stage"};
  std::mt19937 random(20);
  for (int round = 0; round < 20; ++round) {
    const std::string& victim = programs[random() % programs.size()];
    SCOPED_TRACE(victim + ", round " + std::to_string(round));
    programs_.Kill(victim);
    ExpectOthersRun(victim);
    Start(victim);
    const std::uint32_t frames_then = frames();
    const std::uint32_t lips_then = lip_frames();
    ASSERT_TRUE(HoldsUntil(pose, [&] { return Back(victim, frames_then, lips_then); }))
        << programs_.LogOf(victim);
  }
}

TEST_F(Programs, RefuseToPlayTwiceOnOneBoard) {
  Start("kaori-input");
  Start("kaori-lips");
  ASSERT_TRUE(
      Await([&] { return !board_.AcquireWriter<board::Lines>() && !board_.AcquireWriter<board::Lips>(); }));
  for (const std::string program : {"kaori-input", "kaori-lips"}) {
    ProgramRunner second;
    EXPECT_EQ(second.RunToEnd(program, {"--board", programs_.board(), "--links", second.links()}), 1);
    EXPECT_THAT(second.LogOf(program), HasSubstr("held by process"));
    EXPECT_TRUE(programs_.Runs(program));
    EXPECT_EQ(programs_.Stop(program), 0) << "and ends when it is asked to";
  }
}

TEST_F(Programs, RefuseASecondStageOnOneBoardAndTheFirstPlaysOn) {
  Start("kaori-stage");
  ASSERT_TRUE(Await([&] { return !board_.AcquireWriter<board::Lamps>(); }, std::chrono::seconds(30)));
  ProgramRunner second;
  EXPECT_EQ(second.RunToEnd("kaori-stage",
                            {"--board", programs_.board(), "--pack", Pack(), "--links", second.links()}),
            1);
  EXPECT_THAT(second.LogOf("kaori-stage"), HasSubstr("held by process"));
  EXPECT_TRUE(programs_.Runs("kaori-stage"));
}

TEST_F(Programs, SayWhatIsWrongWithTheirOptionsInOneLine) {
  EXPECT_EQ(programs_.RunToEnd("kaori-lips", {"--links", programs_.links(), "--paint", "blue"}), 1);
  EXPECT_THAT(programs_.LogOf("kaori-lips"), HasSubstr("--paint blue: expected three numbers"));
  EXPECT_EQ(programs_.RunToEnd("kaori-input", {"--board", "/no/such/folder/board"}), 1);
  EXPECT_THAT(programs_.LogOf("kaori-input"), HasSubstr("make board /no/such/folder/board"));
  EXPECT_EQ(programs_.RunToEnd("kaori-input", {"--help"}), 0);
  EXPECT_EQ(programs_.RunToEnd("kaori-lips", {"--bored"}), 2);
}

}  // namespace
}  // namespace kaori::test
