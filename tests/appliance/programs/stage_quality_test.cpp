// How finely a stage draws, chosen when it starts.
#include <gtest/gtest.h>

#include <array>

#include "appliance/programs/stage/quality_choice.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using passes::Quality;
using namespace std::chrono_literals;

class QualityChoiceTest : public PackTest {
 protected:
  QualityChoiceTest() : studio_(stage::Studio::Open(SmallShow()).value()) {}

  std::unique_ptr<stage::Studio> studio_;
};

TEST_F(QualityChoiceTest, IsBasicOnAProcessorAndSaysSo) {
  if (passes::QualityFor(studio_->renderer()) != Quality::kBasic)
    GTEST_SKIP() << studio_->renderer() << " is no processor";
  EXPECT_EQ(stage::ChooseQuality(*studio_, "auto"), "basic, since a processor draws");
  EXPECT_EQ(studio_->quality(), Quality::kBasic);
}

TEST_F(QualityChoiceTest, IsAsItWasAskedForAndCanBeTakenBack) {
  EXPECT_EQ(stage::ChooseQuality(*studio_, "fine"), "fine, as asked for");
  EXPECT_EQ(studio_->quality(), Quality::kFine);
  EXPECT_TRUE(studio_->TimeFrame({}, 64, 36));
  EXPECT_TRUE(studio_->SetQuality(Quality::kBasic));
  EXPECT_EQ(studio_->quality(), Quality::kBasic);
}

TEST_F(QualityChoiceTest, MayBeTheFinestOnAProcessorToo) {
  EXPECT_EQ(stage::ChooseQuality(*studio_, "finest"), "finest, as asked for");
  EXPECT_EQ(studio_->quality(), Quality::kFinest);
  EXPECT_TRUE(studio_->TimeFrame({}, 64, 36));
}

TEST(FramesInTime, AreJudgedByTheirMedian) {
  EXPECT_TRUE(stage::IsInTime(std::array<Duration, 3>{3ms, 90ms, 4ms})) << "one hiccup is no slow card";
  EXPECT_FALSE(stage::IsInTime(std::array<Duration, 3>{3ms, 12ms, 13ms}));
  EXPECT_FALSE(stage::IsInTime({}));
}

}  // namespace
}  // namespace kaori::tests
