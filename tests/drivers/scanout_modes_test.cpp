#include <gtest/gtest.h>

#include <vector>

#include "drivers/scanout/kms_output.h"

namespace kaori::scanout {
namespace {

drmModeModeInfo Mode(int width_px, int height_px, std::uint32_t type = DRM_MODE_TYPE_DRIVER) {
  drmModeModeInfo mode{};
  mode.hdisplay = std::uint16_t(width_px);
  mode.vdisplay = std::uint16_t(height_px);
  mode.type = type;
  return mode;
}

TEST(ScreenModes, TheScreensOwnWishIsTakenThoughItIsNotTheLargest) {
  const auto chosen =
      ChooseMode(std::vector{Mode(3840, 2160), Mode(1280, 800, DRM_MODE_TYPE_PREFERRED), Mode(1920, 1080)});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->hdisplay, 1280);
}

TEST(ScreenModes, WithoutAnEdidTheLargestModeThatEveryCableCarriesIsTaken) {
  auto interlaced = Mode(1920, 1080);
  interlaced.flags = DRM_MODE_FLAG_INTERLACE;
  const auto chosen = ChooseMode(std::vector{Mode(640, 480), interlaced, Mode(2560, 1440), Mode(1024, 768)});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->hdisplay, 1024);
}

TEST(ScreenModes, AScreenWithOddModesAloneGetsTheFirstOfThem) {
  const auto chosen = ChooseMode(std::vector{Mode(5120, 2880), Mode(3840, 2160)});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->hdisplay, 5120);
}

TEST(ScreenModes, AScreenWithoutModesShowsNothing) {
  EXPECT_FALSE(ChooseMode({}));
}

TEST(ScreenModes, ThePeriodIsThatOfThePixelClock) {
  auto mode = Mode(1920, 1080);
  mode.clock = 148500;  // kHz: 1080p at 60 Hz, as in CEA-861.
  mode.htotal = 2200;
  mode.vtotal = 1125;
  EXPECT_NEAR(Seconds(PeriodOf(mode)), 1.0 / 60, 1e-8);
}

TEST(ScreenModes, AModeThatDoesNotSayItsClockIsTakenForSixtyHertz) {
  EXPECT_NEAR(Seconds(PeriodOf(Mode(1024, 768))), 1.0 / 60, 1e-8);
}

}  // namespace
}  // namespace kaori::scanout
