// The board is removed, overwritten or cut short while the box plays: it is whole again within two seconds,
// and the picture stays.
#include <filesystem>
#include <fstream>
#include <memory>

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
using std::chrono::seconds;

constexpr Duration kHealed = seconds(2);
constexpr std::uint8_t kHeldKey = 0x14, kNextKey = 0x1A;

struct Loss {
  const char* name;
  void (*harm)(const std::string& board);
  friend void PrintTo(const Loss& h, std::ostream* out) { *out << h.name; }
};

const Loss kLosses[] = {
    {"Removed", [](const std::string& board) { std::filesystem::remove(board); }},
    {"HeadOverwritten",
     [](const std::string& board) {
       std::fstream(board, std::ios::in | std::ios::out | std::ios::binary) << std::string(64, 'x');
     }},
    {"CutToNothing", [](const std::string& board) { std::filesystem::resize_file(board, 0); }},
    {"CutToHalf",
     [](const std::string& board) { std::filesystem::resize_file(board, board::kBoardBytes / 2); }},
};

class ABoxWhoseBoardWas : public ::testing::TestWithParam<Loss> {
 protected:
  ABoxWhoseBoardWas() {
    rig_ = sim::Rig::Open({.folder = programs_.links(),
                           .screen_width_px = 320,
                           .screen_height_px = 180,
                           .screen_period = milliseconds(33)},
                          clock_)
               .value();
  }

  void StartBox() {
    Start("kaori-input");
    Start("kaori-lips");
    Start("kaori-stage");
  }
  void Start(const std::string& program) {
    std::vector<std::string> options{"--links", programs_.links(), "--board", programs_.board()};
    if (program == "kaori-stage")
      options.insert(
          options.end(),
          {"--pack", (ProgramRunner::Programs().parent_path() / "shows" / "kaori.kaori").string()});
    programs_.Start(program, options);
  }

  bool Until(const std::function<bool()>& condition, Duration patience = seconds(30)) {
    return Await(
        [&] {
          rig_->Pump();
          return condition();
        },
        patience);
  }
  void Hold(Duration time) {
    const Time end = clock_.now() + time;
    Until([&] { return clock_.now() >= end; });
  }

  // As a program that starts now would see the box.
  bool Plays() const {
    const auto board = board::Board::Open(programs_.board());
    if (!board) return false;
    const board::Snapshot all = board::ReadAll(*board);
    return all.surface.source == SourceState::kLive && all.sticks[0].source == SourceState::kLive &&
           all.sticks[1].source == SourceState::kLive && all.keys.source == SourceState::kLive &&
           all.lips.source == SourceState::kLive && all.stage_status.source == SourceState::kLive &&
           clock_.now() - all.stage_status.at < milliseconds(500) &&
           clock_.now() - all.lips.at < milliseconds(500);
  }
  Pose PoseNow() const { return PoseOn(board::Board::Open(programs_.board()).value()); }

  SteadyClock clock_;
  ProgramRunner programs_;
  std::unique_ptr<sim::Rig> rig_;
};
INSTANTIATE_TEST_SUITE_P(Lost, ABoxWhoseBoardWas, ::testing::ValuesIn(kLosses),
                         [](const auto& of) { return of.param.name; });

TEST_P(ABoxWhoseBoardWas, PlaysOnOneGoodBoardWithinTwoSecondsAndItsPictureStays) {
  StartBox();
  ASSERT_TRUE(Until([&] { return Plays(); }))
      << programs_.LogOf("kaori-stage") << programs_.LogOf("kaori-input");
  rig_->left_stick().Move(0.6F, -0.3F);
  rig_->dial_box().Turn(2, -0.2);
  rig_->dial_box().Push(1);
  rig_->keyboard().Press(kHeldKey);
  Hold(seconds(2));
  const Pose before = PoseNow();
  ASSERT_GT(before.head_yaw_rad, 0.1F);
  const pid_t stage = programs_.PidOf("kaori-stage");
  GetParam().harm(programs_.board());
  ASSERT_TRUE(Until([&] { return Plays(); }, kHealed)) << programs_.LogOf("kaori-stage");
  for (const char* program : {"kaori-input", "kaori-lips", "kaori-stage"})
    EXPECT_TRUE(programs_.Runs(program)) << programs_.LogOf(program);
  EXPECT_EQ(programs_.PidOf("kaori-stage"), stage);
  EXPECT_EQ(Differs(before, PoseNow()), "");
  Hold(milliseconds(1500));
  EXPECT_EQ(Differs(before, PoseNow()), "") << "nor later, when all have moved";
  rig_->keyboard().Release(kHeldKey);
  rig_->left_stick().Move(0, 0);
  rig_->keyboard().Press(kNextKey);
  EXPECT_TRUE(Until([&] {
    const Pose now = PoseNow();
    return now.head_yaw_rad < 0.01F && (now.keys_down[0] >> kHeldKey & 1U) == 0 &&
           now.key_pushes[kNextKey] == 1;
  })) << "and the operators play on";
}

TEST_P(ABoxWhoseBoardWas, HoldsNothingThatNobodyHolds) {
  StartBox();
  ASSERT_TRUE(Until([&] { return Plays(); })) << programs_.LogOf("kaori-stage");
  rig_->keyboard().Press(kHeldKey);
  rig_->dial_box().Push(3);
  Hold(seconds(1));
  programs_.Kill("kaori-input");
  GetParam().harm(programs_.board());
  rig_->keyboard().Release(kHeldKey);
  const Pose before = [&] {
    Pose pose;
    Until([&] {
      const auto board = board::Board::Open(programs_.board());
      if (!board) return false;
      pose = PoseOn(*board);
      return board->Read<board::StageStatus>().source == SourceState::kLive;
    });
    return pose;
  }();
  EXPECT_EQ(before.keys_down[0] >> kHeldKey & 1U, 0U);
  Start("kaori-input");
  ASSERT_TRUE(Until([&] { return Plays(); })) << programs_.LogOf("kaori-input");
  Hold(seconds(2));
  const Pose now = PoseNow();
  EXPECT_EQ(now.keys_down, decltype(now.keys_down){});
  const Pose then{.knobs = before.knobs, .called = before.called},
      later{.knobs = now.knobs, .called = now.called};
  EXPECT_EQ(Differs(then, later), "") << "counters that begin anew call nothing and turn nothing";
}

}  // namespace
}  // namespace kaori::test
