// Which mode a V4L2 camera is opened in, and what of it is held still.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/camera/v4l2_source.h"
#include "tests/drivers/camera_v4l2_fake.h"

namespace kaori::camera {
namespace {

using ports::CameraHold;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint32_t kYuyv = V4L2_PIX_FMT_YUYV;
constexpr std::uint32_t kMjpeg = V4L2_PIX_FMT_MJPEG;

class V4l2SourceTest : public ::testing::Test {
 protected:
  // What many a webcam offers, and the controls that it has.
  V4l2SourceTest() {
    kernel_.offers = {{kMjpeg, 30, 1920, 1080}, {kMjpeg, 60, 1280, 720}, {kYuyv, 30, 640, 480},
                      {kMjpeg, 120, 640, 480},  {kYuyv, 120, 320, 240},  {kYuyv, 60, 320, 240},
                      {kYuyv, 30, 320, 240},    {kYuyv, 180, 160, 120},  {kYuyv, 5, 320, 240}};
    kernel_.controls = {{V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY},
                        {V4L2_CID_EXPOSURE_ABSOLUTE, 70},
                        {V4L2_CID_EXPOSURE_AUTO_PRIORITY, 1},
                        {V4L2_CID_GAIN, 33},
                        {V4L2_CID_AUTO_WHITE_BALANCE, 1},
                        {V4L2_CID_WHITE_BALANCE_TEMPERATURE, 4100},
                        {V4L2_CID_FOCUS_AUTO, 1},
                        {V4L2_CID_FOCUS_ABSOLUTE, 20},
                        {V4L2_CID_POWER_LINE_FREQUENCY, 1}};
  }
  std::string ModeThatIsOpened() {
    const auto camera = source_.Open();
    EXPECT_TRUE(camera) << camera.error().message();
    return source_.mode();
  }
  std::int32_t At(std::uint32_t control) const { return kernel_.controls.at(control); }

  ManualClock clock_;
  tests::FakeV4l2 kernel_;
  V4l2Source source_{"/dev/video0", {}, clock_, kernel_};
};

TEST_F(V4l2SourceTest, OpensTheSmallestFrameThatIsLargeEnoughAtTheHighestRate) {
  EXPECT_EQ(ModeThatIsOpened(), "320 x 240 YUYV at 120 frames/s");
  EXPECT_EQ(kernel_.chosen().width_px, 320u);
  EXPECT_EQ(kernel_.rate_hz(), 120u);
}

TEST_F(V4l2SourceTest, StepsDownRateByRateWhereItIsTooDarkAndStopsWhereLipsWouldStutter) {
  ASSERT_TRUE(source_.Slower());
  EXPECT_EQ(ModeThatIsOpened(), "320 x 240 YUYV at 60 frames/s");
  ASSERT_TRUE(source_.Slower());
  EXPECT_EQ(ModeThatIsOpened(), "320 x 240 YUYV at 30 frames/s");
  EXPECT_FALSE(source_.Slower()) << "5 frames/s are none";
  EXPECT_EQ(ModeThatIsOpened(), "320 x 240 YUYV at 30 frames/s");
}

TEST_F(V4l2SourceTest, NamesWhatTheCameraGivesNotWhatWasRequested) {
  kernel_.gives = {kMjpeg, 25, 640, 480};
  EXPECT_EQ(ModeThatIsOpened(), "640 x 480 MJPEG at 25 frames/s");
}

TEST_F(V4l2SourceTest, UsesASlowerRateWhereTheBusHasNotRoom) {
  kernel_.narrow_above_hz = 60;
  EXPECT_EQ(ModeThatIsOpened(), "320 x 240 YUYV at 60 frames/s");
  kernel_.narrow_above_hz = 1;
  const auto refused = source_.Open();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().cause, std::errc::no_space_on_device);
  EXPECT_EQ(kernel_.mapped(), 0u);
}

TEST_F(V4l2SourceTest, UsesACameraThatNamesNoSizesAndNoRatesAsItIs) {
  kernel_.failing_error = ENOTTY;
  kernel_.failing_request = VIDIOC_ENUM_FRAMESIZES;
  kernel_.offers = {{kYuyv, 30, 640, 480}};
  EXPECT_EQ(ModeThatIsOpened(), "640 x 480 YUYV at 30 frames/s");
  kernel_.failing_request = VIDIOC_ENUM_FRAMEINTERVALS;
  EXPECT_EQ(ModeThatIsOpened(), "640 x 480 YUYV at the camera's own rate");
}

TEST_F(V4l2SourceTest, LetsTheCameraFindItsExposureWithoutLoweringTheRate) {
  kernel_.controls[V4L2_CID_EXPOSURE_AUTO] = V4L2_EXPOSURE_MANUAL;
  kernel_.controls[V4L2_CID_AUTO_WHITE_BALANCE] = 0;
  ModeThatIsOpened();
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_APERTURE_PRIORITY);
  EXPECT_EQ(At(V4L2_CID_AUTO_WHITE_BALANCE), 1);
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_AUTO_PRIORITY), 0);
  EXPECT_EQ(At(V4L2_CID_POWER_LINE_FREQUENCY), 0) << "120 frames/s cannot fit the mains";
}

TEST_F(V4l2SourceTest, LeavesTheFlickerFilterOfASlowCameraAlone) {
  kernel_.offers = {{kYuyv, 30, 320, 240}};
  ModeThatIsOpened();
  EXPECT_EQ(At(V4L2_CID_POWER_LINE_FREQUENCY), 1);
}

TEST_F(V4l2SourceTest, HoldsWhatTheCameraHasFoundAndFreesItAgain) {
  const auto camera = source_.Open();
  EXPECT_THAT(source_.Set(CameraHold::kHeld), ElementsAre()) << "gain goes with the exposure";
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_ABSOLUTE), 70);
  EXPECT_EQ(At(V4L2_CID_GAIN), 33);
  EXPECT_EQ(At(V4L2_CID_AUTO_WHITE_BALANCE), 0);
  EXPECT_EQ(At(V4L2_CID_FOCUS_AUTO), 0);
  source_.Set(CameraHold::kFree);
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_APERTURE_PRIORITY);
  EXPECT_EQ(At(V4L2_CID_FOCUS_AUTO), 1);
}

TEST_F(V4l2SourceTest, SetsWhatWasHeldAnewInACameraThatForgotIt) {
  auto camera = source_.Open();
  source_.Set(CameraHold::kHeld);
  camera->reset();
  kernel_.controls[V4L2_CID_EXPOSURE_AUTO] = V4L2_EXPOSURE_APERTURE_PRIORITY;
  kernel_.controls[V4L2_CID_EXPOSURE_ABSOLUTE] = 250;
  kernel_.controls[V4L2_CID_WHITE_BALANCE_TEMPERATURE] = 6500;
  kernel_.controls[V4L2_CID_AUTO_WHITE_BALANCE] = 1;
  camera = source_.Open();
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_ABSOLUTE), 70);
  EXPECT_EQ(At(V4L2_CID_AUTO_WHITE_BALANCE), 0);
  EXPECT_EQ(At(V4L2_CID_WHITE_BALANCE_TEMPERATURE), 4100);
}

TEST_F(V4l2SourceTest, SetsNothingOfOneModelInAnother) {
  auto camera = source_.Open();
  source_.Set(CameraHold::kHeld);
  EXPECT_TRUE(source_.holds());
  camera->reset();
  kernel_.model = "Another camera";
  kernel_.controls[V4L2_CID_EXPOSURE_AUTO] = V4L2_EXPOSURE_APERTURE_PRIORITY;
  kernel_.controls[V4L2_CID_EXPOSURE_ABSOLUTE] = 250;
  kernel_.controls[V4L2_CID_GAIN] = 5;
  camera = source_.Open();
  EXPECT_FALSE(source_.holds());
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_APERTURE_PRIORITY);
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_ABSOLUTE), 250);
  EXPECT_EQ(At(V4L2_CID_GAIN), 5);
}

TEST_F(V4l2SourceTest, NamesWhatTheCameraLacksAndWhatItRefuses) {
  const auto camera = source_.Open();
  kernel_.controls.erase(V4L2_CID_FOCUS_AUTO);
  kernel_.controls.erase(V4L2_CID_FOCUS_ABSOLUTE);
  kernel_.stubborn = {V4L2_CID_AUTO_WHITE_BALANCE};
  EXPECT_THAT(source_.Set(CameraHold::kHeld), ElementsAre("white balance", "focus"));
  EXPECT_EQ(At(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_MANUAL) << "the rest is held all the same";
}

TEST_F(V4l2SourceTest, HoldsNothingOfACameraThatIsGoneWhichIsNoError) {
  const auto camera = source_.Open();
  kernel_.open_error = ENODEV;
  EXPECT_THAT(source_.Set(CameraHold::kHeld), IsEmpty());
  EXPECT_FALSE(source_.holds());
  EXPECT_FALSE(source_.Slower());
  EXPECT_FALSE(source_.exposure());
}

TEST_F(V4l2SourceTest, TellsHowMuchOfAFrameIsExposed) {
  EXPECT_FALSE(source_.exposure()) << "none is open";
  const auto camera = source_.Open();
  EXPECT_FLOAT_EQ(source_.exposure().value(), 0.84F);  // 7 ms of 8.3.
  kernel_.controls.erase(V4L2_CID_EXPOSURE_ABSOLUTE);
  EXPECT_FALSE(source_.exposure());
}

TEST_F(V4l2SourceTest, ListsForPeopleWhatTheCameraCanAndWhatIsChosen) {
  const auto text = ModesText("/dev/video0", {}, kernel_);
  ASSERT_TRUE(text);
  EXPECT_THAT(*text, HasSubstr("  1920 x 1080 MJPEG at 30 frames/s\n"));
  EXPECT_THAT(*text, HasSubstr("chosen for lips:\n  320 x 240 YUYV at 120 frames/s\n"
                               "  320 x 240 YUYV at 60 frames/s, where it is too dark for the one above\n"));
  kernel_.open_error = ENOENT;
  EXPECT_EQ(ModesText("/dev/video0", {}, kernel_).error().message(),
            "open /dev/video0: No such file or directory");
}

V4l2Mode Mode(std::uint32_t fourcc, ports::PixelFormat pixels, int width_px, std::uint32_t rate_hz) {
  return {fourcc, {width_px, width_px * 3 / 4, pixels}, 1, rate_hz};
}

TEST(Ladder, PrefersFewBytesOverJpegAndBothOverALargePicture) {
  const auto yuyv = [](int width_px) { return Mode(kYuyv, ports::PixelFormat::kYuyv, width_px, 60); };
  const auto jpeg = [](int width_px) { return Mode(kMjpeg, ports::PixelFormat::kMjpeg, width_px, 60); };
  const auto best = [](std::vector<V4l2Mode> modes) { return NameOf(LadderOf(modes, {}).at(0)); };
  EXPECT_EQ(best({jpeg(320), yuyv(640), yuyv(320)}), "320 x 240 YUYV at 60 frames/s");
  EXPECT_EQ(best({yuyv(640), jpeg(320)}), "320 x 240 MJPEG at 60 frames/s");
  EXPECT_EQ(best({jpeg(640), yuyv(640)}), "640 x 480 YUYV at 60 frames/s");
}

TEST(Ladder, UsesWhatThereIsWhereNothingFitsThePreferences) {
  const std::vector<V4l2Mode> small{Mode(kYuyv, ports::PixelFormat::kYuyv, 160, 15)};
  ASSERT_EQ(LadderOf(small, {}).size(), 1u);
  const std::vector<V4l2Mode> slow{Mode(kYuyv, ports::PixelFormat::kYuyv, 640, 10),
                                   Mode(kYuyv, ports::PixelFormat::kYuyv, 320, 5)};
  EXPECT_EQ(LadderOf(slow, {}).at(0).rate_hz(), 10);
}

TEST(Ladder, CountsTwentyNineNinetySevenAsThirty) {
  std::vector<V4l2Mode> modes{Mode(kYuyv, ports::PixelFormat::kYuyv, 320, 30),
                              Mode(kYuyv, ports::PixelFormat::kYuyv, 640, 30)};
  modes[0].interval_numerator = 1001;
  modes[0].interval_denominator = 30000;
  const auto ladder = LadderOf(modes, {});
  ASSERT_EQ(ladder.size(), 1u);
  EXPECT_EQ(ladder[0].format.width_px, 320);
}

}  // namespace
}  // namespace kaori::camera
