// Whatever befalls the lip camera: the voice or rest has the mouth within 200 ms, the lips are back within 1
// s.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/appliance/core/board_file.h"
#include "tests/appliance/programs/lips_faults.h"

namespace kaori::lips {
namespace {

constexpr double kFall_ms = 200;
constexpr double kBack_ms = 1000;
constexpr double kStrays = 0.1;

class LipFaults : public ::testing::TestWithParam<const char*> {
 protected:
  FaultReport SpendEvening(const Evening& evening) {
    const bool v4l2 = std::string(GetParam()) == "V4l2";
    const auto camera = v4l2 ? MakeSpoiltV4l2Camera(clock_) : MakeSpoiltLocalCamera(file_.folder(), clock_);
    testing::internal::CaptureStderr();
    FaultReport report = Spend(evening, *camera, clock_);
    testing::internal::GetCapturedStderr();
    fmt::print(
        "{} faults: to the voice {:.0f} ms ({}), to rest {:.0f} ms ({}), back {:.0f} ms ({}), astray {:.2f} "
        "({})\n",
        report.faults, report.to_voice_ms, report.to_voice_by, report.to_rest_ms, report.to_rest_by,
        report.back_ms, report.back_by, report.strayed, report.strayed_by);
    return report;
  }

  board::BoardFile file_;
  ManualClock clock_;
};

TEST_P(LipFaults, LeaveTheMouthToTheVoiceOrRestWithin200MsAndGiveItBackWithinASecond) {
  const FaultReport worst = SpendEvening({.faults = 60, .seed = 6});
  EXPECT_EQ(worst.faults, 60);
  EXPECT_LE(worst.to_voice_ms, kFall_ms) << worst.to_voice_by;
  EXPECT_LE(worst.to_rest_ms, kFall_ms) << worst.to_rest_by;
  EXPECT_LE(worst.back_ms, kBack_ms) << worst.back_by;
  EXPECT_LE(worst.strayed, kStrays) << worst.strayed_by;
}

TEST_P(LipFaults, AreSeenByThisCheckWhereADriverWaitsWithoutADeadline) {
  const FaultReport worst = SpendEvening({.faults = 20, .seed = 7, .waits_for_ever = true});
  EXPECT_GT(worst.to_rest_ms, kFall_ms);
  EXPECT_GT(worst.back_ms, kBack_ms);
}

INSTANTIATE_TEST_SUITE_P(Of, LipFaults, ::testing::Values("LocalLink", "V4l2"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace kaori::lips
