// Sound and mouth meet: camera, microphone, screen and loudspeaker are simulated, on one simulated clock.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "tests/appliance/programs/voice_claps.h"

namespace kaori {
namespace {

constexpr double kMostApart_ms = 15;  // Of each clap,
constexpr double kMeanApart_ms = 5;   // and in the mean.

class SoundAndMouth : public ::testing::TestWithParam<tests::ClapOptions> {
 protected:
  static void SetUpTestSuite() {
    auto show = show::LoadPack(KAORI_PACK);
    ASSERT_TRUE(show) << show.error().message();
    studio_ = std::move(*stage::Studio::Open(std::move(*show)));
  }
  static void TearDownTestSuite() { studio_.reset(); }
  ~SoundAndMouth() override { std::filesystem::remove_all(folder_); }

  const std::string folder_ =
      std::filesystem::temp_directory_path() / fmt::format("kaori-claps-{}", ::getpid());
  static std::unique_ptr<stage::Studio> studio_;
};
std::unique_ptr<stage::Studio> SoundAndMouth::studio_;

TEST_P(SoundAndMouth, MeetWithin15Ms) {
  const auto report = tests::ClapIn(folder_, *studio_, GetParam());
  ASSERT_TRUE(report) << report.error().message();
  ASSERT_EQ(report->claps.size(), static_cast<std::size_t>(GetParam().claps)) << "each was seen and heard";
  for (const tests::Clap& clap : report->claps) {
    fmt::print("picture {:5.1f} ms (first frame {:5.1f}), sound {:5.1f} ms: {:+5.1f} ms\n", clap.picture_ms,
               clap.first_frame_ms, clap.sound_ms, clap.apart_ms());
    EXPECT_LE(std::abs(clap.apart_ms()), kMostApart_ms);
  }
  fmt::print("lips {:.1f} ms old in the light, delay {:.1f} ms; mean {:+.1f} ms, worst {:.1f} ms\n",
             report->lips_age_ms, report->delay_ms, report->mean_apart_ms(), report->worst_apart_ms());
  EXPECT_LE(std::abs(report->mean_apart_ms()), kMeanApart_ms);
}

INSTANTIATE_TEST_SUITE_P(
    At, SoundAndMouth,
    ::testing::Values(tests::ClapOptions{.camera_hz = 30, .screen_hz = 60}, tests::ClapOptions{},
                      tests::ClapOptions{.camera_hz = 60, .screen_hz = 30},
                      tests::ClapOptions{.camera_hz = 90, .screen_hz = 120, .claps = 4},
                      tests::ClapOptions{.covered = true},
                      tests::ClapOptions{.microphone_ppm = 200, .loudspeaker_ppm = -200}),
    [](const auto& tested) {
      const tests::ClapOptions& o = tested.param;
      return fmt::format("Camera{}HzScreen{}Hz{}{}", o.camera_hz, o.screen_hz, o.covered ? "LensCovered" : "",
                         o.microphone_ppm != 0 ? "ClocksDrift" : "");
    });

}  // namespace
}  // namespace kaori
