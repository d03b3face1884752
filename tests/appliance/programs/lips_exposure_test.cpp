// The lip camera's exposure: as fast as the light allows, then held for the show.
#include <algorithm>
#include <functional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/programs/lips/camera_exposure.h"
#include "appliance/programs/lips/lip_reader.h"
#include "drivers/camera/v4l2_source.h"
#include "tests/appliance/core/board_file.h"
#include "tests/drivers/camera_v4l2_fake.h"

namespace kaori::lips {
namespace {

using ports::CameraHold;
using std::chrono::milliseconds;
using ::testing::HasSubstr;

// A camera with three rates.
class Tuning final : public ports::CameraTuning {
 public:
  std::string mode() const override { return rates[rung]; }
  std::optional<float> exposure() const override { return exposed; }
  std::vector<std::string> Set(CameraHold to) override {
    holds_of_it.push_back(to);
    return lacks;
  }
  bool holds() const override {
    return there && !holds_of_it.empty() && holds_of_it.back() == CameraHold::kHeld;
  }
  bool Slower() override {
    if (rung + 1 == rates.size()) return false;
    ++rung;
    return true;
  }

  std::vector<std::string> rates{"120 frames/s", "60 frames/s", "30 frames/s"};
  std::size_t rung = 0;
  std::optional<float> exposed = 1.0F;
  std::vector<std::string> lacks;
  std::vector<CameraHold> holds_of_it;
  bool there = true;  // And the model that it was.
};

class Exposure : public ::testing::Test {
 protected:
  // Shows pictures of this luma. Returns whether the camera has to be opened again within the time.
  bool See(std::uint8_t luma, Duration time) {
    std::ranges::fill(picture_, luma);
    const decode::Planes planes{.y = {picture_, 64, 48, 64, 1}, .cb = {}, .cr = {}, .full_range = false};
    for (const Time end = now_ + time; now_ < end; now_ += milliseconds(10))
      if (exposure_.Observe(planes, now_)) return true;
    return false;
  }
  std::string LogOf(const std::function<void()>& play) {
    testing::internal::CaptureStderr();
    play();
    return testing::internal::GetCapturedStderr();
  }

  std::vector<std::uint8_t> picture_ = std::vector<std::uint8_t>(std::size_t{64} * 48);
  Time now_ = Time{} + std::chrono::seconds(10);
  Tuning tuning_;
  CameraExposure exposure_{&tuning_};
};

TEST_F(Exposure, NamesTheModeOnceAndHoldsTheCameraWhenItHasFoundItsExposure) {
  const std::string log = LogOf([&] {
    exposure_.Opened();
    exposure_.Opened();
    EXPECT_FALSE(See(150, milliseconds(1900)));
    EXPECT_FALSE(exposure_.held());
    EXPECT_FALSE(See(150, milliseconds(3000)));
  });
  EXPECT_TRUE(exposure_.held());
  EXPECT_THAT(tuning_.holds_of_it, ::testing::ElementsAre(CameraHold::kHeld));
  EXPECT_THAT(
      log,
      testing::StrEq(
          "kaori: lip camera: 120 frames/s\nkaori: lip camera: exposure and colours are held as they are\n"));
}

TEST_F(Exposure, StepsDownUntilThereIsLightAndSaysSo) {
  const std::string log = LogOf([&] {
    exposure_.Opened();
    EXPECT_TRUE(See(40, milliseconds(2500)));
    exposure_.Opened();
    EXPECT_TRUE(See(60, milliseconds(2500)));
    exposure_.Opened();
    EXPECT_FALSE(See(110, milliseconds(2500)));
  });
  EXPECT_TRUE(exposure_.held());
  EXPECT_THAT(log, HasSubstr("too dark at 120 frames/s; a slower rate is used\n"));
  EXPECT_THAT(log, HasSubstr("lip camera: 30 frames/s\n"));
}

TEST_F(Exposure, AsksForLightWhereTheSlowestRateIsTooDark) {
  tuning_.rung = 2;
  const std::string log = LogOf([&] {
    exposure_.Opened();
    EXPECT_FALSE(See(40, milliseconds(5000)));
  });
  EXPECT_TRUE(exposure_.held());
  EXPECT_THAT(log, HasSubstr("more light on the lips is needed"));
}

TEST_F(Exposure, DoesNotJudgeACoveredLens) {
  LogOf([&] {
    EXPECT_FALSE(See(20, std::chrono::seconds(60)));
    EXPECT_FALSE(exposure_.held());
    EXPECT_FALSE(See(150, milliseconds(2500)));
  });
  EXPECT_TRUE(exposure_.held());
  EXPECT_EQ(tuning_.rung, 0u);
}

TEST_F(Exposure, WaitsForAnExposureThatIsStillGrowingButNotForEver) {
  tuning_.exposed = 0.3F;
  LogOf([&] {
    EXPECT_FALSE(See(40, milliseconds(3800)));
    EXPECT_TRUE(See(40, milliseconds(400)));
  });
}

TEST_F(Exposure, FreesTheCameraForACalibrationAndHoldsItAfterwards) {
  const std::string log = LogOf([&] {
    tuning_.lacks = {"focus"};
    exposure_.Hold();
    exposure_.Free();
    EXPECT_FALSE(See(150, std::chrono::seconds(10)));
    EXPECT_FALSE(exposure_.held()) << "until the calibration is over";
    exposure_.Hold();
    EXPECT_FALSE(See(40, std::chrono::seconds(10))) << "an exposure that a person holds is not judged";
  });
  EXPECT_THAT(tuning_.holds_of_it,
              ::testing::ElementsAre(CameraHold::kHeld, CameraHold::kFree, CameraHold::kHeld));
  const auto first = log.find("cannot be held: focus");
  EXPECT_NE(first, log.npos);
  EXPECT_EQ(log.find("cannot be held", first + 1), log.npos) << "named once: " << log;
}

TEST_F(Exposure, IsFoundAnewWhereAnotherModelIsPluggedIn) {
  const std::string log = LogOf([&] {
    exposure_.Opened();
    EXPECT_FALSE(See(150, milliseconds(2500)));
    EXPECT_TRUE(exposure_.held());
    exposure_.Opened();
    EXPECT_TRUE(exposure_.held()) << "the same one";
    tuning_.there = false;
    exposure_.Opened();
    EXPECT_FALSE(exposure_.held());
    tuning_.there = true;
    EXPECT_FALSE(See(150, milliseconds(2500)));
  });
  EXPECT_TRUE(exposure_.held());
  EXPECT_THAT(log, HasSubstr("another one; exposure and colours are found anew"));
  EXPECT_THAT(tuning_.holds_of_it, ::testing::ElementsAre(CameraHold::kHeld, CameraHold::kHeld));
}

TEST_F(Exposure, IsNotSaidToBeHeldWhereNoCameraIsThere) {
  const std::string log = LogOf([&] {
    exposure_.Free();
    tuning_.there = false;
    exposure_.Hold();
    EXPECT_FALSE(exposure_.held());
    tuning_.there = true;
    exposure_.Opened();
    EXPECT_FALSE(See(150, milliseconds(2500)));
  });
  EXPECT_TRUE(exposure_.held()) << "once it has found its exposure";
  EXPECT_THAT(log, HasSubstr("none is there to be held"));
  EXPECT_EQ(log.find("are held as they are"), log.rfind("are held as they are"));
}

TEST_F(Exposure, LeavesACameraAloneThatHasNothingToTune) {
  CameraExposure exposure(nullptr);
  exposure.Opened();
  exposure.Hold();
  exposure.Free();
  const decode::Planes planes{.y = {picture_, 64, 48, 64, 1}, .cb = {}, .cr = {}, .full_range = false};
  EXPECT_FALSE(exposure.Observe(planes, now_));
}

TEST(Brightness, IsThatOfTheBrightestTenth) {
  std::vector<std::uint8_t> luma(std::size_t{64} * 48, 16);
  std::fill_n(luma.begin(), luma.size() / 8, std::uint8_t{235});
  decode::Planes planes{.y = {luma, 64, 48, 64, 1}, .cb = {}, .cr = {}, .full_range = false};
  EXPECT_FLOAT_EQ(BrightnessOf(planes), 1);
  std::fill_n(luma.begin(), luma.size(), std::uint8_t{16});
  EXPECT_FLOAT_EQ(BrightnessOf(planes), 0);
}

// All of it: the reader, the driver, and a camera that sees the more the longer its frames are.
TEST(DimStage, HasTheCameraOpenedSlowerUntilItSeesAndThenHeldOverAPulledCable) {
  const board::BoardFile file;
  const board::Board board = file.Open();
  ManualClock clock;
  tests::FakeV4l2 kernel;
  for (const std::uint32_t rate_hz : {30U, 60U, 120U})
    kernel.offers.push_back({V4L2_PIX_FMT_YUYV, rate_hz, 320, 240});
  kernel.controls = {{V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY},
                     {V4L2_CID_EXPOSURE_ABSOLUTE, 333}};
  camera::V4l2Source source("/dev/video0", {}, clock, kernel);
  LipReader reader(source.opener(), board, board.AcquireWriter<board::Lips>().value(), {}, clock, &source);
  const auto play = [&](Duration time) {
    for (const Time end = clock.now() + time; clock.now() < end; clock.Advance(milliseconds(10))) {
      kernel.Expose(static_cast<std::uint8_t>(16 + 2400 / std::max(kernel.rate_hz(), 1U)), clock.now());
      reader.Step();
    }
  };
  testing::internal::CaptureStderr();
  play(std::chrono::seconds(12));
  EXPECT_EQ(source.mode(), "320 x 240 YUYV at 30 frames/s");
  EXPECT_TRUE(reader.exposure().held());
  EXPECT_EQ(kernel.controls[V4L2_CID_EXPOSURE_AUTO], V4L2_EXPOSURE_MANUAL);
  kernel.controls[V4L2_CID_EXPOSURE_AUTO] = V4L2_EXPOSURE_APERTURE_PRIORITY;
  kernel.failing_error = ENODEV;
  play(milliseconds(100));
  kernel.failing_error = 0;
  play(std::chrono::seconds(1));
  EXPECT_EQ(kernel.controls[V4L2_CID_EXPOSURE_AUTO], V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(kernel.rate_hz(), 30u);
  const std::string log = testing::internal::GetCapturedStderr();
  EXPECT_THAT(
      log,
      HasSubstr(
          "lip camera: the picture is too dark at 320 x 240 YUYV at 60 frames/s; a slower rate is used\n"));
  EXPECT_THAT(log, HasSubstr("lip camera: these controls cannot be held: gain, white balance, focus\n"));
}

}  // namespace
}  // namespace kaori::lips
