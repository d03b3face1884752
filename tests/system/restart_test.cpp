// Programs die at random; the others play on, and nothing that an audience sees changes.
#include <fstream>
#include <memory>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/board/snapshot.h"
#include "hw-sim/links/local/rig.h"
#include "tests/system/pose.h"
#include "tests/system/program_runner.h"

namespace kaori::test {
namespace {

using board::SourceState;
using std::chrono::milliseconds;
using ::testing::HasSubstr;

constexpr std::uint8_t kKeyQ = 0x14;

// The programs of the box before a screen small enough for a processor without a GPU.
class Programs : public ::testing::Test {
 protected:
  Programs() : board_(board::Board::Create(programs_.board()).value()) {}

  void StartBox() {
    for (const char* program : {"kaori-input", "kaori-lips", "kaori-stage"}) Start(program);
  }

  void Start(const std::string& program, std::vector<std::string> more = {}) {
    std::vector<std::string> options{"--links", programs_.links()};
    if (program != "kaori-sim") options.insert(options.end(), {"--board", programs_.board()});
    if (program == "kaori-sim") options.insert(options.end(), {"--size", "320x180", "--hz", "30"});
    if (program == "kaori-stage") options.insert(options.end(), {"--pack", Pack()});
    options.insert(options.end(), more.begin(), more.end());
    programs_.Start(program, options);
  }

  static std::string Pack() {
    return (ProgramRunner::Programs().parent_path() / "shows" / "kaori.kaori").string();
  }

  bool AllLive() const {
    const board::Snapshot all = board::ReadAll(board_);
    return all.surface.source == SourceState::kLive && all.sticks[0].source == SourceState::kLive &&
           all.sticks[1].source == SourceState::kLive && all.keys.source == SourceState::kLive &&
           all.lips.source == SourceState::kLive && all.lips.value.rest_width > 0;
  }

  std::uint32_t frames() const { return board_.Read<board::StageStatus>().value.frames; }
  std::uint32_t lip_frames() const { return board_.Read<board::Lips>().value.frames; }

  // What must go on while `dead` is away. Programs that depend on it wait for it, and that is no fault.
  void ExpectOthersRun(const std::string& dead) {
    for (const char* other : {"kaori-input", "kaori-lips", "kaori-stage"})
      EXPECT_TRUE(other == dead || programs_.Runs(other))
          << other << " died with " << dead << ": " << programs_.LogOf(other);
    if (dead == "kaori-sim") return;
    const std::uint32_t frames_then = frames();
    const std::uint32_t lips_then = lip_frames();
    const auto plays_on = [&] {
      return Between() && (dead == "kaori-stage" || frames() > frames_then) &&
             (dead == "kaori-lips" || lip_frames() > lips_then);
    };
    EXPECT_TRUE(Await(plays_on));
  }

  // Waits until two poses are the same that are a quarter of a second and ten frames apart: a stage on a busy machine may
  // draw none in that time, and an unmoved pose would say nothing.
  ::testing::AssertionResult Settle(Pose& pose) {
    const bool settled = Await([&] {
      pose = PoseOn(board_);
      const std::uint32_t ten_later = frames() + 10;
      Hold(milliseconds(250));
      Await([&] { return Between() && frames() >= ten_later; });
      return Differs(pose, PoseOn(board_)).empty();
    });
    if (settled) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << Differs(pose, PoseOn(board_));
  }

  void Hold(Duration time) {
    const Time end = SteadyClock().now() + time;
    Await([&] { return Between() && SteadyClock().now() >= end; });
  }

  // Looks at the pose each millisecond until `back` holds, and a little longer.
  ::testing::AssertionResult HoldsUntil(const Pose& pose, const std::function<bool()>& back) {
    std::string differs;
    const auto same = [&] {
      if (differs.empty()) differs = Differs(pose, PoseOn(board_));
      return Between() && differs.empty();
    };
    const bool came_back = Await([&] { return !same() || back(); });
    const Time end = SteadyClock().now() + milliseconds(100);
    Await([&] { return !same() || SteadyClock().now() >= end; });
    if (!differs.empty()) return ::testing::AssertionFailure() << differs;
    if (!came_back) return ::testing::AssertionFailure() << "it did not come back";
    return ::testing::AssertionSuccess();
  }

  // What the test itself does between two looks.
  virtual bool Between() { return true; }

  ProgramRunner programs_;
  board::Board board_;
};

// Here the devices live in the test, so that it can hold them while programs die.
class HeldControls : public Programs {
 protected:
  HeldControls() {
    rig_ = sim::Rig::Open({.folder = programs_.links(),
                           .screen_width_px = 320,
                           .screen_height_px = 180,
                           .screen_period = milliseconds(33)},
                          clock_)
               .value();
  }

  bool Between() override {
    rig_->Pump();
    return true;
  }

  void PlayControls() {
    for (int dial = 0; dial < 8; ++dial) rig_->dial_box().Turn(dial, dial % 2 == 0 ? 0.3 : -0.2);
    rig_->dial_box().Push(1);
    rig_->left_stick().Move(0.6F, -0.3F);
    rig_->right_stick().Move(-0.5F, 0.2F);
    rig_->keyboard().Press(kKeyQ);
    rig_->camera().SetMouth(0.6, 0.8);
  }

  bool Serves(const std::string& program) const {
    if (program == "kaori-input") return rig_->connected("dial-box") && rig_->connected("keyboard");
    if (program == "kaori-lips") return rig_->connected("camera");
    return rig_->connected("screen");
  }

  SteadyClock clock_;
  std::unique_ptr<sim::Rig> rig_;
};

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
