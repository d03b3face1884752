// What a card refuses: a mode, several screens at a time, a picture of that size. The others play on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/drivers/scanout_fixture.h"

namespace kaori::scanout {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in milliseconds.
using ::testing::HasSubstr;
using tests::FakeCard;
using tests::ModeOf;

class RefusedScreens : public tests::Screens {
 protected:
  // Opens anew after each refusal, as the stage does; the screen that shows, or none after so many tries.
  std::unique_ptr<KmsScreen> Settle(int most = 8) {
    for (; most > 0; --most) {
      auto screen = TryOpen();
      if (!screen) {
        said_ = screen.error().message();
        continue;
      }
      const auto flip = Frame(**screen);
      if (flip) return std::move(*screen);
      said_ = flip.error().message();
    }
    return nullptr;
  }
  std::string said_;
};

TEST_F(RefusedScreens, AModeThatTheCardRefusesGivesWayToTheScreensNextOne) {
  card_.most_px = 2000;
  card_.PlugIn(0);
  card_.PlugIn(1, {ModeOf(3840, 2160), ModeOf(1920, 1080, DRM_MODE_TYPE_DRIVER)});
  const auto screen = Settle();
  ASSERT_TRUE(screen) << said_;
  EXPECT_THAT(said_, HasSubstr("show HDMI-A-2 3840 x 2160"));
  EXPECT_EQ(size_px_, std::pair(640 + 1920, 1080));
  EXPECT_THAT(Describe(screen->wall()),
              HasSubstr("HDMI-A-2 1920 x 1080 at 60 Hz, in place of what the card refuses"));
  EXPECT_TRUE(Frames(*screen, 1s));
}

TEST_F(RefusedScreens, TheWallStandsWithoutAScreenNoneOfWhoseModesIsTaken) {
  card_.most_px = 600;
  card_.PlugIn(0, {ModeOf(480, 270)});
  card_.PlugIn(1, {ModeOf(3840, 2160), ModeOf(1920, 1080, DRM_MODE_TYPE_DRIVER)});
  const auto screen = Settle();
  ASSERT_TRUE(screen) << said_;
  EXPECT_EQ(size_px_, std::pair(480, 270));
  EXPECT_TRUE(Frames(*screen, 3s)) << "the one that is left out is not new";
  EXPECT_EQ(card_.Value(card_.connectors[1].id, "CRTC_ID"), 0U);
}

TEST_F(RefusedScreens, AModeThatPeopleAskForGivesWayToo) {
  card_.most_px = 1000;
  card_.PlugIn(0, {ModeOf(800, 600)});
  preferences_.mode = ParseMode("1920x1080@60");
  ASSERT_TRUE(Settle()) << said_;
  EXPECT_EQ(size_px_, std::pair(800, 600));
}

TEST_F(RefusedScreens, OfScreensThatAreTooManyTogetherTheLastOneGivesWay) {
  card_.most_active = 2;
  for (std::size_t i = 0; i < 3; ++i) card_.PlugIn(i);
  const auto screen = Settle();
  ASSERT_TRUE(screen) << said_;
  EXPECT_EQ(size_px_, std::pair(1280, 480));
  EXPECT_TRUE(Frames(*screen, 1s));
}

TEST_F(RefusedScreens, ARefusalIsForgottenWithItsScreen) {
  card_.most_px = 1000;
  card_.PlugIn(0);
  card_.PlugIn(1, {ModeOf(1920, 1080), ModeOf(800, 600, DRM_MODE_TYPE_DRIVER)});
  ASSERT_TRUE(Settle());
  EXPECT_EQ(size_px_.first, 640 + 800);
  card_.Pull(1);
  ASSERT_TRUE(Settle());
  card_.most_px = 4000;
  card_.PlugIn(1, {ModeOf(1920, 1080)});
  ASSERT_TRUE(Settle());
  EXPECT_EQ(size_px_.first, 640 + 1920);
}

TEST_F(RefusedScreens, ACardThatRefusedEverythingIsAskedOnceMoreAfterAWhile) {
  card_.most_px = 100;
  card_.PlugIn(0);
  EXPECT_FALSE(Settle());
  card_.most_px = 4000;
  EXPECT_FALSE(Settle()) << "not at once: it would be asked for ever";
  clock_.Advance(6s);
  EXPECT_TRUE(Settle());
}

TEST_F(RefusedScreens, AFlipThatIsPendingIsNoRefusal) {
  card_.PlugIn(0);
  const auto screen = Open();
  ASSERT_TRUE(screen->Acquire());
  card_.commit_fault = std::errc::device_or_resource_busy;
  EXPECT_FALSE(screen->Present(1));
  EXPECT_TRUE(preferences_.refused.empty());
  EXPECT_EQ(card_.test_commits, 0);
}

TEST_F(RefusedScreens, AWallThatIsTooLargeForOnePictureGivesUpItsLargestScreensMode) {
  card_.PlugIn(0);
  card_.PlugIn(1, {ModeOf(16000, 9000), ModeOf(1024, 768, DRM_MODE_TYPE_DRIVER)});
  largest_px_ = 8192;
  ASSERT_TRUE(Settle()) << said_;
  EXPECT_EQ(size_px_, std::pair(640 + 1024, 768));
}

}  // namespace
}  // namespace kaori::scanout
