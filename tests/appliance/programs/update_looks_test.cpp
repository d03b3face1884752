// What is looked at while a version is tried: its picture, its screen, its programs, and its disk.
#include "appliance/programs/update/looks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/hw-sim/link_fixture.h"

namespace kaori::update {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;

std::string Picture(int width, int height, int at, std::uint8_t inside, std::uint8_t outside) {
  std::string ppm = "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double right = (x + 0.5 - width / 2.0) / height, down = (y + 0.5) / height - 0.5;
      const bool is_inside = (right - at / 100.0) * (right - at / 100.0) + down * down < 0.09;
      ppm += std::string(3, static_cast<char>(is_inside ? inside : outside));
    }
  return ppm;
}

TEST(UpdateLooks, KnowAFaceOnScreensOfOtherSizesAndShapes) {
  const std::string still = Picture(960, 540, 0, 200, 40);
  EXPECT_TRUE(PictureFault(Picture(960, 540, 0, 200, 40), {still}).empty());
  EXPECT_TRUE(PictureFault(Picture(640, 480, 0, 204, 44), {still}).empty());
  EXPECT_TRUE(PictureFault(Picture(300, 200, 1, 200, 40), {"", still}).empty()) << "it breathes";
}

TEST(UpdateLooks, FindABlackPictureAnotherFaceAndNone) {
  const std::string still = Picture(960, 540, 0, 200, 40);
  EXPECT_THAT(PictureFault(Picture(960, 540, 0, 0, 0), {still}).english, HasSubstr("not that of the face"));
  EXPECT_THAT(PictureFault(Picture(960, 540, 40, 200, 40), {still}).english,
              HasSubstr("not that of the face"));
  EXPECT_THAT(PictureFault("", {still}).english, HasSubstr("no picture"));
  EXPECT_THAT(PictureFault(still.substr(0, still.size() - 1), {still}).english, HasSubstr("no picture"));
  EXPECT_THAT(PictureFault("P6\n99999 1\n255\n", {still}).english, HasSubstr("no picture"));
  EXPECT_THAT(PictureFault(still, {}).english, HasSubstr("not that of the face"));
}

TEST(UpdateLooks, FindAScreenThatTakesNoNewFrames) {
  const Time began = ManualClock().now();
  ShownFrames never;
  EXPECT_EQ(never.Fault(Time{}, began).english, "the screen takes no new frames")
      << "none came since the machine started";
  ShownFrames frames;
  EXPECT_TRUE(frames.Fault(began, began).empty());
  EXPECT_TRUE(frames.Fault(began + seconds(5), began + seconds(5)).empty());
  EXPECT_TRUE(frames.Fault(began + seconds(5), began + seconds(24)).empty()) << "a frame may take long";
  EXPECT_FALSE(frames.Fault(began + seconds(5), began + seconds(25)).empty())
      << "the stage goes on to draw without a screen";
  EXPECT_FALSE(frames.Fault(began + seconds(5), began + seconds(60)).empty());
  EXPECT_TRUE(frames.Fault(began + seconds(65), began + seconds(65)).empty()) << "it is plugged in again";
}

TEST(UpdateLooks, FindAProgramThatDoesNotRunOrWasStartedAnew) {
  const std::string stage = "Id=kaori-stage.service\nNRestarts=0\nActiveState=active\n\n";
  const auto fault = [&stage](const std::string& lips, Restarts restarts = Restarts::kAreFaults) {
    return ProgramsFault(stage + lips, 2, restarts).english;
  };
  EXPECT_EQ(fault("Id=kaori-lips.service\nNRestarts=0\nActiveState=active\n"), "");
  EXPECT_EQ(fault("Id=kaori-lips.service\nNRestarts=1\nActiveState=active\n"),
            "kaori-lips.service had to be started anew");
  EXPECT_EQ(fault("Id=kaori-lips.service\nNRestarts=0\nActiveState=activating\n"),
            "kaori-lips.service does not run");
  EXPECT_EQ(fault(""), "it is not known which programs run");
  EXPECT_EQ(fault("Id=kaori-lips.service\nNRestarts=1\nActiveState=active\n", Restarts::kAreNone), "")
      << "the other system shows no face at all";
  EXPECT_EQ(fault("Id=kaori-lips.service\nNRestarts=1\nActiveState=failed\n", Restarts::kAreNone),
            "kaori-lips.service does not run");
}

TEST(UpdateLooks, FindABlockThatFailedVerity) {
  EXPECT_TRUE(DiskFault("a\nb\n").empty());
  EXPECT_THAT(DiskFault("a\ndevice-mapper: verity: 253:0: data block 12 is corrupted\n").english,
              HasSubstr("verity: 253:0: data block 12 is corrupted"));
}

}  // namespace
}  // namespace kaori::update
