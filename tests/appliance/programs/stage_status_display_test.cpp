// The stage's status display: what it shows beside the show, and what it leaves for others to read.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "appliance/core/board/lines.h"
#include "appliance/programs/stage/stage_status_display.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in milliseconds.

constexpr int kWidth_px = 320, kHeight_px = 200;
constexpr const char* kScreensText = "HDMI-A-1 640x480 60 wanted picture\n";

class HeldDisplay final : public ports::SideDisplay {
 public:
  int width_px() const override { return kWidth_px; }
  int height_px() const override { return kHeight_px; }
  bool fresh() const override { return shows == 0; }
  Result<void> Show(std::span<const std::uint8_t> rgbx, std::span<const ports::DisplayArea> areas) override {
    ++calls;
    for (const auto& area : areas) rows += area.top_px - area.bottom_px;
    picture.assign(rgbx.begin(), rgbx.end());
    if (fault != std::errc()) return Fail(fault, "show on the held display");
    ++shows;
    return {};
  }

  std::errc fault{};
  int calls = 0;
  int shows = 0;
  int rows = 0;
  std::vector<std::uint8_t> picture;
};

class ScreenBesideADisplay final : public ports::Scanout {
 public:
  int pollable() const override { return -1; }
  Result<ports::PixelBuffer> Acquire() override { return ports::PixelBuffer{}; }
  Result<void> Present(std::uint64_t) override { return {}; }
  Result<ports::Flip> ReadFlip() override { return ports::Flip{}; }
  ports::SideDisplay* status_display() override { return plugged ? &held : nullptr; }
  ports::SideDisplay* monitor_display() override { return monitor_plugged ? &monitor : nullptr; }
  std::vector<ports::Output> outputs() const override {
    return {{.connector = "HDMI-A-1", .width_px = 640, .height_px = 480, .rate_hz = 60}};
  }

  HeldDisplay held, monitor;
  bool plugged = true, monitor_plugged = false;
};

class StageStatus : public ::testing::Test {
 protected:
  void Steps(int count) {
    for (; count > 0; --count) {
      clock_.Advance(StageStatusDisplay::kPeriod);
      display_.Step(&screen_);
    }
  }
  // The file comes from another thread, in its own time.
  bool IsLeft(const std::string& text) const {
    for (int i = 0; i < 5000; ++i) {
      std::ifstream file(place_.folder() / "screens");
      if (file && std::string(std::istreambuf_iterator<char>(file), {}) == text) return true;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }
  void PlugBox(board::SourceState source) { surface_.Write({}, clock_.now(), source); }

  board::BoardFile place_;
  board::Board board_ = place_.Open();
  void SwitchServiceKey(bool on) {
    lines_.Write({.active = on ? 1U << static_cast<unsigned>(board::Line::kService) : 0}, clock_.now(),
                 board::SourceState::kLive);
  }

  board::Writer<board::Surface> surface_ = board_.AcquireWriter<board::Surface>().value();
  board::Writer<board::Lines> lines_ = board_.AcquireWriter<board::Lines>().value();
  ManualClock clock_;
  ScreenBesideADisplay screen_;
  StageStatusDisplay display_{board_, clock_, {place_.folder(), place_.folder() / "screens"}};
};

TEST_F(StageStatus, StandsWithinThreeSecondsAndIsThenLeftAlone) {
  Steps(1);
  ASSERT_TRUE(IsLeft(kScreensText)) << "it is one of the facts, and comes from another thread";
  Steps(29);
  EXPECT_GT(std::ranges::count_if(screen_.held.picture, [](auto byte) { return byte > 200; }), 100)
      << "letters";
  const int before = screen_.held.calls;
  Steps(20);
  EXPECT_EQ(screen_.held.calls, before) << "nothing changed";
}

TEST_F(StageStatus, NeverDrawsMoreThanALineAtOnceWhenThereIsNoTimeToSpare) {
  Steps(1);
  for (int i = 0; i < 30; ++i) {
    const int before = screen_.held.rows;
    Steps(1);
    EXPECT_LE(screen_.held.rows - before, kHeight_px / 10);
  }
}

TEST_F(StageStatus, SaysWithinTwoSecondsThatTheDialBoxWasPulled) {
  PlugBox(board::SourceState::kLive);
  Steps(40);
  const auto before = screen_.held.picture;
  PlugBox(board::SourceState::kStale);
  Steps(20);
  EXPECT_NE(screen_.held.picture, before);
}

TEST_F(StageStatus, WhatCouldNotBeShownAtOnceIsShownLater) {
  Steps(40);
  screen_.held.fault = std::errc::device_or_resource_busy;
  PlugBox(board::SourceState::kLive);
  Steps(3);
  const int before = screen_.held.shows;
  screen_.held.fault = {};
  Steps(1);
  EXPECT_GT(screen_.held.shows, before);
}

TEST_F(StageStatus, ThatCannotShowIsLeftAloneForAMinute) {
  screen_.held.fault = std::errc::invalid_argument;
  Steps(100);
  EXPECT_EQ(screen_.held.calls, 1);
  screen_.held.fault = {};
  Steps(600);
  EXPECT_GT(screen_.held.shows, 0);
}

TEST_F(StageStatus, LeavesTheScreensForOthersToRead) {
  Steps(1);
  EXPECT_TRUE(IsLeft(kScreensText));
  display_.Step(nullptr);
  EXPECT_TRUE(IsLeft(""));
}

TEST_F(StageStatus, HasTheMonitorWhileTheServiceKeyIsOn) {
  screen_.plugged = false;
  screen_.monitor_plugged = true;
  Steps(10);
  EXPECT_FALSE(display_.on_monitor());
  EXPECT_EQ(screen_.monitor.calls, 0) << "the operators have it in a show";
  SwitchServiceKey(true);
  Steps(30);
  EXPECT_TRUE(display_.on_monitor());
  EXPECT_GT(std::ranges::count_if(screen_.monitor.picture, [](auto byte) { return byte > 200; }), 100);
  SwitchServiceKey(false);
  Steps(1);
  EXPECT_FALSE(display_.on_monitor());
  const int rows = screen_.monitor.rows;
  SwitchServiceKey(true);
  Steps(1);
  EXPECT_EQ(screen_.monitor.rows, rows + kHeight_px) << "all of it, since the monitor was drawn there";
}

TEST_F(StageStatus, LeavesTheMonitorAloneWhereItHasAScreenOfItsOwn) {
  screen_.monitor_plugged = true;
  SwitchServiceKey(true);
  Steps(30);
  EXPECT_FALSE(display_.on_monitor());
  EXPECT_EQ(screen_.monitor.calls, 0);
  EXPECT_GT(screen_.held.calls, 0);
}

TEST_F(StageStatus, WithoutADisplayNothingIsDrawn) {
  screen_.plugged = false;
  Steps(10);
  EXPECT_EQ(screen_.held.calls, 0);
  EXPECT_TRUE(IsLeft(kScreensText)) << "but the screens are told";
}

}  // namespace
}  // namespace kaori::stage
