// The programs of the box as processes, and devices that a test holds itself.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "appliance/core/board/snapshot.h"
#include "hw-sim/links/local/rig.h"
#include "tests/system/pose.h"
#include "tests/system/program_runner.h"

namespace kaori::test {

inline constexpr std::uint8_t kKeyQ = 0x14;

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
    using enum board::SourceState;
    return all.surface.source == kLive && all.sticks[0].source == kLive && all.sticks[1].source == kLive &&
           all.keys.source == kLive && all.lips.source == kLive && all.lips.value.rest_width > 0;
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
      Hold(std::chrono::milliseconds(250));
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
    const Time end = SteadyClock().now() + std::chrono::milliseconds(100);
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
                           .screen_period = std::chrono::milliseconds(33)},
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

}  // namespace kaori::test
