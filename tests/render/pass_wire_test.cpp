// The wireframe: what of the eyes is seen in it.
#include <gtest/gtest.h>

#include "tests/render/pass_studio.h"

namespace kaori {
namespace {

using tests::Difference;
using tests::PassStudio;
using tests::Picture;

// Nothing but the eyes follows the gaze, so that pictures of two gazes differ where eyes are seen.
double EyesSeen(float shut) {
  const auto picture = [shut](float yaw_rad) {
    scene::Scene scene = tests::PlainScene(scene::Style::kWire);
    scene.weights.lids_shut = {shut, shut};
    scene.gaze.fill({.yaw_rad = yaw_rad});
    return PassStudio::Shared().Draw(scene, 640, 480);
  };
  return Difference(picture(-0.3F), picture(0.3F));
}

TEST(Wire, ShowsTheEyesBetweenTheLidsAndNothingOfThemBehindShutOnes) {
  const double open = EyesSeen(0), half = EyesSeen(0.6F);
  EXPECT_GT(open, 0.01);
  EXPECT_LT(half, open);
  EXPECT_GT(half, 0);
  EXPECT_EQ(EyesSeen(1), 0);
}

}  // namespace
}  // namespace kaori
