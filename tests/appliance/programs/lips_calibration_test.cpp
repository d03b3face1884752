// The calibration of paint and mouth on site, and the file that keeps it.
#include <unistd.h>
#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/programs/lips/calibration.h"
#include "appliance/programs/lips/generations.h"
#include "appliance/programs/lips/lip_meter.h"
#include "hw-sim/devices/lip_scene.h"

namespace kaori::lips {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

// An operator before the camera, at thirty frames a second.
class OnSite {
 public:
  explicit OnSite(const sim::LipScene& before_the_camera) : scene(before_the_camera) {}

  decode::Planes Look() {
    scene.camera.sequence++;
    sim::PaintScene(scene, {kWidth, kHeight, yuyv_});
    const ports::CameraFrame frame{.at = now,
                                   .format = {kWidth, kHeight, ports::PixelFormat::kYuyv},
                                   .stride_bytes = kWidth * 2,
                                   .bytes = yuyv_};
    return reader_.Read(frame).value();
  }

  sim::LipScene scene;
  Time now = Time{} + std::chrono::seconds(1);
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 240;

 private:
  std::vector<std::uint8_t> yuyv_ = std::vector<std::uint8_t>(std::size_t{2} * kWidth * kHeight);
  decode::PlaneReader reader_;
};

// The lips are 0.12 high each: their middle lies at 0.52 of the picture's height, the lower one a little
// below.
constexpr float kLipX = 0.5F;
constexpr float kLipY = 0.55F;

TEST(Calibration, SamplesAnyPaintByOneClickInAnyLight) {
  for (const sim::Rgb& paint : {sim::Rgb{0.08F, 0.24F, 0.78F},
                                {0.05F, 0.62F, 0.2F},
                                {0.78F, 0.06F, 0.38F},
                                {0.9F, 0.85F, 0.1F},
                                {0.5F, 0.1F, 0.7F}}) {
    for (const sim::Rgb& light : {sim::Rgb{1, 1, 1}, {1.1F, 0.85F, 0.6F}, {0.4F, 0.4F, 0.4F}}) {
      sim::LipScene scene;
      scene.person.paint = paint;
      scene.light.colour = light;
      OnSite site(scene);
      Calibration calibration({});
      const auto sampled = calibration.SamplePaint(site.Look(), kLipX, kLipY);
      ASSERT_TRUE(sampled) << sampled.error().message();
      LipMeter meter(calibration.settings(), {});
      const board::Lips lips = meter.Measure(site.Look(), site.now);
      EXPECT_GT(lips.quality, 0.8F) << "paint " << paint.red << ", light " << light.red;
      ASSERT_TRUE(meter.detection());
      EXPECT_NEAR(meter.detection()->contour.width_px, sim::kRestMouthOfPicture * OnSite::kWidth, 2);
    }
  }
}

TEST(Calibration, RefusesAClickOnGreyOnTwoColoursAndOutside) {
  OnSite site({});
  Calibration calibration({});
  const auto planes = site.Look();
  const auto complaint = [&](float x, float y) {
    const auto sampled = calibration.SamplePaint(planes, x, y);
    return sampled ? std::string("none") : sampled.error().message();
  };
  EXPECT_THAT(complaint(0.02F, 0.1F), HasSubstr("grey")) << "the dark room";
  EXPECT_THAT(complaint(0.5F, 0.575F), HasSubstr("several colours")) << "the lip's edge";
  EXPECT_THAT(complaint(1.2F, 0.5F), HasSubstr("outside"));
  EXPECT_THAT(complaint(std::nanf(""), 0.5F), HasSubstr("outside"));
  EXPECT_EQ(calibration.settings(), LipSettings{});
  EXPECT_FALSE(calibration.Revert()) << "nothing changed, so there is nothing to undo";
}

board::Lips Seen(float height, float width) {
  board::Lips lips;
  lips.height = height;
  lips.width = width;
  lips.quality = 1;
  lips.rest_width = 0.3F;
  return lips;
}

// Shows the calibration a mouth that is held. Returns whether that completed the step.
bool Hold(Calibration& calibration, const board::Lips& lips, Time& now, Duration time) {
  bool done = false;
  for (Duration t{}; t < time; t += milliseconds(33)) done |= calibration.Feed(lips, now += milliseconds(33));
  return done;
}

TEST(Calibration, MeasuresShutOpenWideAndNarrowInASecondEach) {
  Calibration calibration({});
  Time now = Time{} + std::chrono::seconds(1);
  const auto take = [&](CalibrationStep step, float height, float width) {
    calibration.Begin(step);
    board::Lips lips = Seen(height, width);
    if (step != CalibrationStep::kShut) lips.rest_width = 0.33F;  // As the first step found it.
    EXPECT_TRUE(Hold(calibration, lips, now, milliseconds(1100)));
    EXPECT_FALSE(calibration.step());
  };
  take(CalibrationStep::kShut, 0.26F, 1.1F);
  take(CalibrationStep::kOpen, 1.0F, 1.0F);
  take(CalibrationStep::kWide, 0.3F, 1.2F);
  take(CalibrationStep::kNarrow, 0.35F, 0.6F);
  const GaugeSettings& gauge = calibration.settings().gauge;
  EXPECT_NEAR(gauge.rest_width, 0.33F, 1e-3);
  EXPECT_NEAR(gauge.extents.shut, 0.266F, 0.005);
  EXPECT_NEAR(gauge.extents.open, 0.95F, 1e-3);
  EXPECT_NEAR(gauge.extents.wide, 1.19F, 1e-3);
  EXPECT_NEAR(gauge.extents.narrow, 0.62F, 1e-3);
}

TEST(Calibration, IsNotMisledByAHeldMouthThatLooksLikeANearerHead) {
  Calibration calibration({});
  Time now = Time{} + std::chrono::seconds(1);
  calibration.Begin(CalibrationStep::kShut);
  ASSERT_TRUE(Hold(calibration, Seen(0.25F, 1), now, milliseconds(1100)));
  calibration.Begin(CalibrationStep::kWide);
  board::Lips wide = Seen(0.27F, 1.1F);
  wide.rest_width = 0.327F;  // The gauge has crept towards it: in truth it is 1.2 wide.
  ASSERT_TRUE(Hold(calibration, wide, now, milliseconds(1100)));
  EXPECT_NEAR(calibration.settings().gauge.extents.wide, 1.19F, 0.005);
}

TEST(Calibration, MeasuresTheRangeInTenSecondsOfSpeech) {
  Calibration calibration({});
  Time now = Time{} + std::chrono::seconds(1);
  calibration.Begin(CalibrationStep::kSpeak);
  bool done = false;
  int frames = 0;
  for (; !done && frames < 1000; ++frames) {
    const float swing = static_cast<float>(frames % 20) / 19;  // Shut to open, narrow to wide, evenly.
    done = calibration.Feed(Seen(0.25F + 0.5F * swing, 0.7F + 0.5F * swing), now += milliseconds(33));
  }
  EXPECT_NEAR(frames, 304, 3) << "ten seconds";
  const Extents& extents = calibration.settings().gauge.extents;
  EXPECT_NEAR(extents.shut, 0.33F, 0.03);
  EXPECT_NEAR(extents.open, 0.73F, 0.03);
  EXPECT_NEAR(extents.narrow, 0.72F, 0.03);
  EXPECT_NEAR(extents.wide, 1.18F, 0.03);
}

TEST(Calibration, WaitsWhileNoMouthIsSeenAndNeverGivesAReversedRange) {
  Calibration calibration({});
  Time now = Time{} + std::chrono::seconds(1);
  calibration.Begin(CalibrationStep::kOpen);
  board::Lips lost = Seen(3, 3);
  lost.quality = 0;
  EXPECT_FALSE(Hold(calibration, lost, now, std::chrono::seconds(5)));
  EXPECT_EQ(calibration.progress(), 0);
  EXPECT_TRUE(Hold(calibration, Seen(0.1F, 1), now, milliseconds(1100))) << "an open mouth that is shut";
  const Extents& extents = calibration.settings().gauge.extents;
  EXPECT_GT(extents.open, extents.shut + 0.1F);
  EXPECT_TRUE(ParseLipSettings(LipSettingsText(calibration.settings()), "own"));
}

TEST(Calibration, UndoesEveryChange) {
  Calibration calibration({});
  Time now = Time{} + std::chrono::seconds(1);
  std::vector<LipSettings> states{calibration.settings()};
  for (const auto step : {CalibrationStep::kShut, CalibrationStep::kOpen, CalibrationStep::kWide}) {
    calibration.Begin(step);
    Hold(calibration, Seen(0.5F, 1.15F), now, milliseconds(1100));
    states.push_back(calibration.settings());
  }
  for (std::size_t n = states.size() - 1; n-- > 0;) {
    EXPECT_TRUE(calibration.Revert());
    EXPECT_EQ(calibration.settings(), states[n]);
  }
  EXPECT_FALSE(calibration.Revert());
}

TEST(Calibration, CountsOnAndGoesBackWhereMoreWasChangedThanCanBeUndone) {
  Calibration calibration({});
  const auto change = [&](int n) {
    LipSettings settings = calibration.settings();
    settings.key.spill = static_cast<float>(n);
    calibration.Set(settings);
  };
  for (int n = 1; n <= 1500; ++n) change(n);
  EXPECT_EQ(calibration.changes(), 1500U);
  change(7);
  change(8);
  EXPECT_EQ(calibration.changes(), 1502U) << "a change is seen as one";
  calibration.RevertTo(1500);
  EXPECT_EQ(calibration.settings().key.spill, 1500);
  calibration.RevertTo(0);
  EXPECT_EQ(calibration.changes(), 502U) << "older ones are forgotten, and stay";
}

class LipSettingsFile : public ::testing::Test {
 protected:
  LipSettingsFile() { std::filesystem::create_directories(folder_); }
  ~LipSettingsFile() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("kaori-lips-" + std::to_string(::getpid()));
  std::filesystem::path file_ = folder_ / "lips.settings";
};

TEST_F(LipSettingsFile, KeepsEveryValue) {
  LipSettings settings;
  settings.paint = {13, 158, 51};
  settings.key = {180.5F, 60, 120};
  settings.marker = true;
  settings.gauge = {0.3125F, {4, 33}, {0.3F, 0.9F, 0.7F, 1.2F}};
  settings.voice = {-41.5F, 120};
  const auto parsed = ParseLipSettings(LipSettingsText(settings), "lips.settings");
  ASSERT_TRUE(parsed) << parsed.error().message();
  EXPECT_EQ(*parsed, settings);
  ASSERT_TRUE(WriteGeneration(file_, settings));
  EXPECT_EQ(ReadGenerations(file_).now, settings);
}

TEST_F(LipSettingsFile, KeepsWhatItHeldWhereItCannotBeWritten) {
  ASSERT_TRUE(WriteGeneration(file_, {}));
  std::filesystem::create_directories(folder_ / "occupied" / "by a folder");
  EXPECT_FALSE(WriteGeneration(folder_ / "occupied", {}));
  EXPECT_FALSE(WriteGeneration(file_ / "lips.settings", {})) << "a file is no folder";
  EXPECT_EQ(ReadGenerations(file_).now, LipSettings{});
}

TEST_F(LipSettingsFile, NamesTheLineThatIsWrong) {
  const auto complaint = [](const char* text) {
    const auto read = ParseLipSettings(text, "lips.toml");
    return read ? std::string("none") : read.error().message();
  };
  EXPECT_EQ(complaint("# a note\n\n paint.red = 12 # dark\r\n"), "none");
  EXPECT_THAT(complaint("paint.red = 12\npaint.rde = 3\n"),
              HasSubstr("lips.toml:2: there is no setting paint.rde"));
  EXPECT_THAT(complaint("paint.red = 300"), HasSubstr("lips.toml:1: paint.red is not between 0 and 255"));
  EXPECT_THAT(complaint("key.spill = nan"), HasSubstr("not between"));
  EXPECT_THAT(complaint("key.spill = 3x"), HasSubstr("3x is not a number"));
  EXPECT_THAT(complaint("key.spill"), HasSubstr("a name, = and a number"));
  EXPECT_THAT(complaint("mouth.shut = 0.9\nmouth.open = 0.8"),
              HasSubstr("mouth.shut is not below mouth.open"));
}

}  // namespace
}  // namespace kaori::lips
