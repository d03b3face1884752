// The rig's screen through its real socket and shared memory: what is shown, and exactly when.
#include <algorithm>

#include "drivers/scanout/local_screen.h"
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
