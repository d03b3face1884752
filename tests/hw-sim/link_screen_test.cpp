// The rig's screen through its real socket and shared memory: what is shown, and exactly when.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "drivers/scanout/local_screen.h"
#include "firmware/wire/link_monitor.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

constexpr Duration kScreenPeriod = 16'666'667ns;

class LinkScreen : public LinkFixture {
 protected:
  void SetUp() override {
    LinkFixture::SetUp();
    start = clock.now();
    Reopen();
  }

  void Reopen() {
    auto opened = scanout::LocalScreen::Open(folder.path());
    ASSERT_TRUE(opened) << opened.error().message();
    screen = std::move(*opened);
    rig->Pump();
  }

  void PresentGrey(std::uint64_t frame, std::uint8_t grey) {
    const auto buffer = screen->Acquire();
    ASSERT_TRUE(buffer) << buffer.error().message();
    std::ranges::fill(buffer->memory(), grey);
    ASSERT_TRUE(screen->Present(frame));
    rig->Pump();
  }

  Time start;
  std::unique_ptr<ports::Scanout> screen;
};

TEST_F(LinkScreen, AsksToTryAgainUntilTheScreenAnswers) {
  ASSERT_TRUE(rig->Unplug("screen"));
  ASSERT_TRUE(rig->Plug("screen"));
  screen = *scanout::LocalScreen::Open(folder.path());
  EXPECT_EQ(screen->Acquire().error().cause, std::errc::resource_unavailable_try_again);
  rig->Pump();
  EXPECT_EQ(screen->ReadFlip().error().cause, std::errc::resource_unavailable_try_again);
  EXPECT_TRUE(screen->Acquire());
}

TEST_F(LinkScreen, HasAMonitorBesideItForAsLongAsSomebodyShowsOne) {
  EXPECT_EQ(screen->monitor_display(), nullptr) << "nobody shows it: the stage draws none";
  ASSERT_TRUE(rig->monitor().Plug());
  EXPECT_EQ(rig->monitor().Read(), nullptr) << "nothing was drawn yet";
  ports::SideDisplay* monitor = screen->monitor_display();
  ASSERT_NE(monitor, nullptr);
  EXPECT_EQ(screen->monitor_display(), monitor) << "the same one";
  ASSERT_EQ(monitor->width_px(), 1280);
  ASSERT_EQ(monitor->height_px(), 720);
  EXPECT_TRUE(monitor->fresh());
  std::vector<std::uint8_t> rgbx(std::size_t{1280} * 720 * 4, 10);
  ASSERT_TRUE(monitor->Show(rgbx, std::array{ports::DisplayArea{0, 0, 1280, 720}}));
  EXPECT_FALSE(monitor->fresh());
  const auto* shown = rig->monitor().Read();
  ASSERT_NE(shown, nullptr);
  EXPECT_EQ(*shown, rgbx);
  EXPECT_EQ(rig->monitor().Read(), nullptr) << "it was read already";
  std::ranges::fill(rgbx, 200);
  ASSERT_TRUE(monitor->Show(rgbx, std::array{ports::DisplayArea{0, 1, 1280, 2}}));
  shown = rig->monitor().Read();
  ASSERT_NE(shown, nullptr);
  constexpr std::size_t kRow = 1280 * 4;
  EXPECT_EQ(shown->at(kRow - 1), 10) << "the row below the area";
  EXPECT_EQ(shown->at(kRow), 200);
  EXPECT_EQ(shown->at(2 * kRow), 10);
  EXPECT_FALSE(monitor->Show(rgbx, std::array{ports::DisplayArea{0, 0, 1280, 721}}));
  EXPECT_FALSE(monitor->Show(std::span(rgbx).first(4), {}));
  rig->monitor().Unplug();
  EXPECT_EQ(screen->monitor_display(), nullptr);
  EXPECT_FALSE(std::filesystem::exists(folder.path() + wire::kMonitorFile));
}

TEST_F(LinkScreen, TakesAMonitorThatWasMadeAnewOrCutShortAsItIs) {
  ASSERT_TRUE(rig->monitor().Plug());
  ports::SideDisplay* monitor = screen->monitor_display();
  ASSERT_NE(monitor, nullptr);
  const std::vector<std::uint8_t> rgbx(std::size_t{1280} * 720 * 4, 10);
  ASSERT_TRUE(monitor->Show(rgbx, std::array{ports::DisplayArea{0, 0, 1280, 720}}));
  rig->monitor().Unplug();
  ASSERT_TRUE(rig->monitor().Plug());
  monitor = screen->monitor_display();
  ASSERT_NE(monitor, nullptr);
  EXPECT_TRUE(monitor->fresh()) << "it is blank, and all of it is drawn";
  ASSERT_TRUE(monitor->Show(rgbx, std::array{ports::DisplayArea{0, 0, 1280, 720}}));
  std::filesystem::resize_file(folder.path() + wire::kMonitorFile, 100);
  EXPECT_EQ(rig->monitor().Read(), nullptr);
  ASSERT_TRUE(monitor->Show(rgbx, std::array{ports::DisplayArea{0, 0, 1280, 720}})) << "it is as long again";
  EXPECT_NE(rig->monitor().Read(), nullptr);
  rig->monitor().Unplug();
  std::ofstream(folder.path() + wire::kMonitorFile) << "no monitor at all, but as long as a header";
  EXPECT_EQ(screen->monitor_display(), nullptr);
}

TEST_F(LinkScreen, IsAnOutputOfTheStatusOnceItHasAnsweredUntilItIsUnplugged) {
  EXPECT_TRUE(screen->Acquire());
  const auto outputs = screen->outputs();
  ASSERT_EQ(outputs.size(), 1U) << "or the status says that there is no screen";
  EXPECT_EQ(outputs[0].connector, "simulator");
  EXPECT_EQ(outputs[0].width_px, screen->Acquire()->width_px);
  EXPECT_NEAR(outputs[0].rate_hz, 60, 0.01);
  ASSERT_TRUE(rig->Unplug("screen"));
  EXPECT_FALSE(screen->ReadFlip());
  EXPECT_TRUE(screen->outputs().empty());
}

TEST_F(LinkScreen, FlipsAtTheVerticalBlankAndSaysWhen) {
  for (std::uint64_t n = 1; n <= 10; ++n) {
    clock.Advance(3ms);
    PresentGrey(n, static_cast<std::uint8_t>(n));
    EXPECT_EQ(screen->ReadFlip().error().cause, std::errc::resource_unavailable_try_again);
    EXPECT_EQ(screen->Acquire().error().cause, std::errc::resource_unavailable_try_again);
    Step(kScreenPeriod - 3ms - 1ns);
    EXPECT_EQ(screen->ReadFlip().error().cause, std::errc::resource_unavailable_try_again);
    Step(1ns);
    const auto flip = screen->ReadFlip();
    ASSERT_TRUE(flip) << flip.error().message();
    EXPECT_EQ(flip->at, start + static_cast<std::int64_t>(n) * kScreenPeriod);
    EXPECT_EQ(flip->frame, n);
    EXPECT_EQ(flip->period, kScreenPeriod);
  }
  EXPECT_EQ(rig->screen().frames_shown(), 10u);
}

TEST_F(LinkScreen, ShowsThePixelsThatWereDrawn) {
  EXPECT_FALSE(rig->screen().latest());
  PresentGrey(7, 0xAB);
  EXPECT_FALSE(rig->screen().latest());
  Step(kScreenPeriod);
  const auto shown = rig->screen().latest();
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->frame, 7u);
  EXPECT_EQ(shown->width_px, 64);
  EXPECT_EQ(shown->height_px, 48);
  EXPECT_EQ(shown->rgbx.size(), 64u * 48 * 4);
  EXPECT_TRUE(std::ranges::all_of(shown->rgbx, [](std::uint8_t b) { return b == 0xAB; }));
}

TEST_F(LinkScreen, DrawingDoesNotTouchThePictureThatStands) {
  PresentGrey(1, 0x11);
  Step(kScreenPeriod);
  ASSERT_TRUE(screen->ReadFlip());
  std::ranges::fill(screen->Acquire()->memory(), 0x22);
  rig->Pump();
  EXPECT_EQ(rig->screen().latest()->rgbx[0], 0x11);
}

TEST_F(LinkScreen, TheLastPictureStandsWhileTheProgramIsRestarted) {
  PresentGrey(1, 0x33);
  Step(kScreenPeriod);
  screen.reset();
  Step(kScreenPeriod);
  EXPECT_EQ(rig->screen().latest()->rgbx[100], 0x33);
  Reopen();
  std::ranges::fill(screen->Acquire()->memory(), 0x44);
  Step(kScreenPeriod);
  EXPECT_EQ(rig->screen().latest()->rgbx[100], 0x33);
  PresentGrey(1, 0x44);
  Step(kScreenPeriod);
  EXPECT_EQ(rig->screen().latest()->rgbx[100], 0x44);
}

TEST_F(LinkScreen, AProgramThatDiesBeforeItsFlipShowsNothing) {
  PresentGrey(1, 0x55);
  screen.reset();
  Step(kScreenPeriod);
  EXPECT_FALSE(rig->screen().latest());
}

TEST_F(LinkScreen, ANewModeIsForTheProgramToOpenAnew) {
  PresentGrey(1, 0x66);
  Step(kScreenPeriod);
  rig->screen().SetMode({128, 72, 20ms});
  rig->Pump();
  ASSERT_TRUE(screen->ReadFlip());  // What was shown before is still told,
  EXPECT_EQ(screen->ReadFlip().error().cause, std::errc::no_such_device);
  EXPECT_EQ(screen->Acquire().error().cause, std::errc::no_such_device);
  Reopen();
  const auto buffer = screen->Acquire();
  ASSERT_TRUE(buffer);
  EXPECT_EQ(buffer->width_px, 128);
  EXPECT_EQ(rig->screen().latest()->width_px, 64);  // and the old picture stands until the new one.
}

TEST_F(LinkScreen, APulledCableDarkensTheScreen) {
  PresentGrey(1, 0x77);
  Step(kScreenPeriod);
  ASSERT_TRUE(rig->Unplug("screen"));
  EXPECT_FALSE(rig->screen().latest());
  ASSERT_TRUE(screen->ReadFlip());
  EXPECT_EQ(screen->ReadFlip().error().cause, std::errc::no_such_device);
  EXPECT_EQ(screen->Present(2).error().cause, std::errc::invalid_argument);
  ASSERT_TRUE(rig->Plug("screen"));
  Reopen();
  EXPECT_TRUE(screen->Acquire());
}

TEST_F(LinkScreen, ALateSimulatorShowsAtTheLastBlankThatPassed) {
  PresentGrey(1, 1);
  Step(3 * kScreenPeriod + 2ms);
  EXPECT_EQ(screen->ReadFlip()->at, start + 3 * kScreenPeriod);
}

TEST_F(LinkScreen, TellsWhenItNeedsThePumpNext) {
  EXPECT_GT(rig->next_due(), start + 1h);  // Nothing waits; the camera has no driver.
  clock.Advance(1ms);
  PresentGrey(1, 1);
  EXPECT_EQ(rig->next_due(), start + kScreenPeriod);
}

}  // namespace
}  // namespace kaori::sim
