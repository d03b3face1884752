// The mouth against its truth, under every light and in all clothes: what is promised, as a gate.
#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/appliance/lips_truth.h"

namespace kaori::lips {
namespace {

constexpr int kFrames = 36;

void Report(const Truth& truth) {
  fmt::print("{:<38} height {:5.2f} %  width {:5.2f} %  opening {:5.2f} %  longest loss {:4.0f} ms\n",
             truth.name, 100 * truth.height_error, 100 * truth.width_error, 100 * truth.opening_error,
             truth.longest_loss_ms);
}

std::string TestName(const testing::TestParamInfo<Condition>& info) {
  std::string name;
  for (const char c : info.param.name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
  return name;
}

class OrdinaryStage : public testing::TestWithParam<Condition> {};

// Each condition by itself, not only their mean.
TEST_P(OrdinaryStage, IsMeasuredWithinTwoPercentAndNeverLostForATenthOfASecond) {
  const Truth truth = MeasureTruth(GetParam(), kFrames);
  Report(truth);
  EXPECT_LE(truth.height_error, 0.02);
  EXPECT_LE(truth.width_error, 0.02);
  EXPECT_LE(truth.opening_error, 0.03);
  EXPECT_LE(truth.longest_loss_ms, 100);
}

INSTANTIATE_TEST_SUITE_P(Lips, OrdinaryStage, testing::ValuesIn(NormalSet()), TestName);

class HardStage : public testing::TestWithParam<Condition> {};

// Reported as it is; what is believed is a mouth all the same, and what is lost comes back.
TEST_P(HardStage, IsReportedAndNeverTakesAnotherThingForAMouth) {
  const Truth truth = MeasureTruth(GetParam(), kFrames);
  Report(truth);
  EXPECT_LE(truth.height_error, 0.15);
  EXPECT_LE(truth.width_error, 0.15);
  EXPECT_LE(truth.longest_loss_ms, 600);
}

INSTANTIATE_TEST_SUITE_P(Lips, HardStage, testing::ValuesIn(HardSet()), TestName);

}  // namespace
}  // namespace kaori::lips
