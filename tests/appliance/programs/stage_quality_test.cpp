// How finely a stage draws, chosen when it starts.
#include <gmock/gmock.h>
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

// A screen that lends pictures of one size.
class ScreenOfSize final : public ports::Scanout {
 public:
  ScreenOfSize(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}
  int pollable() const override { return -1; }
  Result<ports::PixelBuffer> Acquire() override { return ports::PixelBuffer{width_px_, height_px_, {}}; }
  Result<void> Present(std::uint64_t /*frame*/) override { return {}; }
  Result<ports::Flip> ReadFlip() override { return Fail(std::errc::no_such_device, "show pictures"); }

 private:
  int width_px_, height_px_;
};

TEST_F(QualityChoiceTest, IsMadeAnewForALargerScreenAndOnlyOnce) {
  if (passes::QualityFor(studio_->renderer()) != Quality::kBasic)
    GTEST_SKIP() << studio_->renderer() << " is no processor, and what it chooses depends on how fast it is";
  ScreenOfSize usual(1920, 1080), large(3840, 2160);
  stage::QualityForScreens sizes(*studio_, "auto");
  ::testing::internal::CaptureStderr();
  for (ScreenOfSize* const screen : {&usual, &large, &large, &usual}) sizes.See(*screen);
  stage::QualityForScreens as_asked(*studio_, "fine");
  as_asked.See(large);
  EXPECT_THAT(
      ::testing::internal::GetCapturedStderr(),
      ::testing::MatchesRegex("[^\n]*quality basic, since a processor draws at 3840 x 2160 pixels\n"));
}

TEST(FramesInTime, AreJudgedByTheirMedian) {
  EXPECT_TRUE(stage::IsInTime(std::array<Duration, 3>{3ms, 90ms, 4ms})) << "one hiccup is no slow card";
  EXPECT_FALSE(stage::IsInTime(std::array<Duration, 3>{3ms, 12ms, 13ms}));
  EXPECT_FALSE(stage::IsInTime({}));
}

}  // namespace
}  // namespace kaori::tests
