#include <gtest/gtest.h>

#include <vector>

#include "drivers/scanout/kms_mode.h"

namespace kaori::scanout {
namespace {

drmModeModeInfo Mode(int width_px, int height_px, std::uint32_t type = DRM_MODE_TYPE_DRIVER) {
  drmModeModeInfo mode{};
  mode.hdisplay = std::uint16_t(width_px);
  mode.vdisplay = std::uint16_t(height_px);
  mode.type = type;
  return mode;
}

TEST(ScreenModes, TheScreensPreferredModeIsChosenThoughItIsNotTheLargest) {
  const auto chosen =
      ChooseMode(std::vector{Mode(3840, 2160), Mode(1280, 800, DRM_MODE_TYPE_PREFERRED), Mode(1920, 1080)});
  EXPECT_EQ(chosen.mode.hdisplay, 1280);
}

TEST(ScreenModes, WithoutAnEdidTheLargestModeThatEveryCableCarriesIsChosen) {
  auto interlaced = Mode(1920, 1080);
  interlaced.flags = DRM_MODE_FLAG_INTERLACE;
  const auto chosen = ChooseMode(std::vector{Mode(640, 480), interlaced, Mode(2560, 1440), Mode(1024, 768)});
  EXPECT_EQ(chosen.mode.hdisplay, 1024);
}

TEST(ScreenModes, AScreenWithOddModesAloneGetsTheFirstOfThem) {
  const auto chosen = ChooseMode(std::vector{Mode(5120, 2880), Mode(3840, 2160)});
  EXPECT_EQ(chosen.mode.hdisplay, 5120);
}

TEST(ScreenModes, AScreenThatNamesNoModeAtAllGetsWhatEveryScreenShows) {
  const auto chosen = ChooseMode({});
  EXPECT_EQ(chosen.origin, ports::ModeOrigin::kSafeGuess);
  EXPECT_EQ(chosen.mode.hdisplay, 640);
  EXPECT_NEAR(Seconds(PeriodOf(chosen.mode)), 1.0 / 59.94, 1e-5);
}

TEST(ScreenModes, APreferredModeThatIsNoModeIsPassedOver) {
  const auto chosen = ChooseMode(std::vector{Mode(0, 1080, DRM_MODE_TYPE_PREFERRED),
                                             Mode(60000, 60000, DRM_MODE_TYPE_PREFERRED), Mode(800, 600)});
  EXPECT_EQ(chosen.origin, ports::ModeOrigin::kSafeGuess);
  EXPECT_EQ(chosen.mode.hdisplay, 800);
}

TEST(ScreenModes, AModeThatPeopleAskForHasItsRate) {
  for (const auto& [text, rate_hz] :
       {std::pair{"1920x1080@60", 60}, {"1280x720@50", 50}, {"640x480@240", 240}, {"320x200@4", 4}}) {
    const auto mode = ParseMode(text);
    ASSERT_TRUE(mode) << text;
    EXPECT_NEAR(1 / Seconds(PeriodOf(*mode)), rate_hz, rate_hz * 2e-3) << text;
    EXPECT_LT(mode->hdisplay, mode->hsync_start);
    EXPECT_LT(mode->hsync_end, mode->htotal);
    EXPECT_LT(mode->vsync_end, mode->vtotal);
  }
}

TEST(ScreenModes, TimesAModeAsVesaDoes) {
  const auto mode = ParseMode("1920x1080@60");  // CVT 1.2 with reduced blanking: 138.5 MHz, 2080 x 1111.
  ASSERT_TRUE(mode);
  EXPECT_EQ(mode->htotal, 2080);
  EXPECT_NEAR(mode->vtotal, 1111, 1);
  EXPECT_NEAR(mode->clock, 138500, 300);
}

TEST(ScreenModes, TextThatIsNoModeIsNone) {
  for (const char* text :
       {"", "1920", "1920x1080", "1920x1080@", "x@", "0x480@60", "640x0@60", "640x480@0", "-640x480@60",
        "640x480@60Hz", "99999x480@60", "640x480@99999", " 640x480@60", "640X480@60"})
    EXPECT_FALSE(ParseMode(text)) << text;
}

TEST(ScreenModes, ThePeriodIsThatOfThePixelClock) {
  auto mode = Mode(1920, 1080);
  mode.clock = 148500;  // kHz: 1080p at 60 Hz, as in CEA-861.
  mode.htotal = 2200;
  mode.vtotal = 1125;
  EXPECT_NEAR(Seconds(PeriodOf(mode)), 1.0 / 60, 1e-8);
}

TEST(ScreenModes, AModeThatDoesNotSayItsClockCountsAsSixtyHertz) {
  EXPECT_NEAR(Seconds(PeriodOf(Mode(1024, 768))), 1.0 / 60, 1e-8);
}

}  // namespace
}  // namespace kaori::scanout
