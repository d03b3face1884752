// The stick pod's core: axes that are taught, a hat of four switches, silence at rest.
#include <gtest/gtest.h>

#include <vector>

#include "firmware/surface/stick_pod.h"
#include "tests/firmware/proof/nor.h"

namespace kaori::surface {
namespace {

constexpr std::uint16_t kMiddle = 2047;
constexpr StickPod::Codes kRest{kMiddle, kMiddle, kMiddle, 0};

class AStickPod : public ::testing::Test {
 protected:
  AStickPod() {
    pod.SetHost(Host::kThere);
    Hold(kRest, 0);
    pod.NextReport();
  }
  // Everything as it is for 40 ms. Returns how many reports that made.
  int Hold(const StickPod::Codes& codes, std::uint32_t closed) { return Hold(pod, codes, closed); }
  int Hold(StickPod& held, const StickPod::Codes& codes, std::uint32_t closed) {
    int reports = 0;
    for (int tick = 0; tick < 160; ++tick) {
      StickPod::Codes trembling = codes;
      for (auto& code : trembling) code = static_cast<std::uint16_t>(code - (code == 0 ? 0 : dice.Throw(2)));
      held.Tick(closed, trembling);
      reports += held.NextReport() ? 1 : 0;
    }
    return reports;
  }
  bool Command(wire::SurfaceOperation operation, std::uint8_t number) {
    return pod.Accept(ReportKind::kFeature,
                      wire::Encode(wire::SurfaceCommand{.operation = operation, .number = number}));
  }

  proof::Nor flash;
  proof::Dice dice{7};
  StickPod pod{{}, nullptr, &flash};
};

TEST_F(AStickPod, SendsNothingWhileNobodyTouchesIt) {
  for (int n = 0; n < 20; ++n) EXPECT_EQ(Hold(kRest, 0), 0);
  EXPECT_EQ(pod.Standing().x, 0);
  EXPECT_EQ(pod.Standing().slider, 0);
}

TEST_F(AStickPod, ReachesTheEndsOfItsAxesEachOnItsOwnPlace) {
  EXPECT_GT(Hold({4095, kMiddle, kMiddle, 0}, 0), 0);
  EXPECT_EQ(pod.Standing().x, 32767);
  EXPECT_EQ(pod.Standing().y, 0);
  Hold({kMiddle, 1, kMiddle, 0}, 0);
  EXPECT_EQ(pod.Standing().x, 0);
  EXPECT_EQ(pod.Standing().y, -32767);
  Hold({kMiddle, kMiddle, 4095, 4095}, 0);
  EXPECT_EQ(pod.Standing().twist, 32767);
  EXPECT_EQ(pod.Standing().slider, 65535);
}

TEST_F(AStickPod, TellsTheHatsEightWaysAndNoneOfImpossibleOnes) {
  const std::vector<std::pair<std::uint32_t, int>> ways{{1, 0}, {3, 1}, {2, 2},  {6, 3},  {4, 4},   {12, 5},
                                                        {8, 6}, {9, 7}, {0, 15}, {5, 15}, {10, 15}, {15, 15}};
  for (const auto& [switches, way] : ways) {
    Hold(kRest, switches << 12);
    EXPECT_EQ(pod.Standing().hat, way) << switches;
  }
}

TEST_F(AStickPod, TellsEveryButtonOnceEachWay) {
  for (unsigned button = 0; button < wire::kStickPodButtons; ++button) {
    EXPECT_EQ(Hold(kRest, 1U << button), 1) << button;
    EXPECT_EQ(pod.Standing().buttons_down, 1U << button);
    EXPECT_EQ(Hold(kRest, 0), 1) << button;
  }
}

TEST_F(AStickPod, KeepsTheEndsThatItWasTaught) {
  const StickPod::Codes left{1000, 1000, 1000, 1000};
  const StickPod::Codes right{3000, 3000, 3000, 3000};
  ASSERT_TRUE(Command(wire::SurfaceOperation::kCalibrate, 1));
  Hold(left, 0);
  Hold(right, 0);
  EXPECT_TRUE(Command(wire::SurfaceOperation::kCalibrate, 0));
  Hold(right, 0);
  EXPECT_EQ(pod.Standing().x, 32767);
  StickPod next({}, nullptr, &flash);
  Hold(next, left, 0);
  EXPECT_EQ(next.Standing().x, -32767);
}

TEST_F(AStickPod, RefusesACalibrationInWhichAnAxisWasNotMoved) {
  EXPECT_FALSE(Command(wire::SurfaceOperation::kCalibrate, 0)) << "it was not begun";
  EXPECT_TRUE(Command(wire::SurfaceOperation::kCalibrate, 1));
  Hold({4000, 4000, kMiddle, 4000}, 0);
  Hold({100, 100, kMiddle, 100}, 0);
  EXPECT_FALSE(Command(wire::SurfaceOperation::kCalibrate, 0));
  EXPECT_FALSE(Command(wire::SurfaceOperation::kCalibrate, 2));
  EXPECT_EQ(flash.operations(), 0u);
  Hold({4095, kMiddle, kMiddle, 0}, 0);
  EXPECT_EQ(pod.Standing().x, 32767) << "as before";
}

TEST_F(AStickPod, TellsAHostThatComesHowItStands) {
  Hold({4095, kMiddle, kMiddle, 0}, 2);
  pod.SetHost(Host::kGone);
  pod.SetHost(Host::kThere);
  const auto report = pod.NextReport();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->x, 32767);
  EXPECT_EQ(report->buttons_down, 2);
  EXPECT_FALSE(pod.NextReport());
}

}  // namespace
}  // namespace kaori::surface
