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

TEST_F(QualityChoiceTest, IsAsItWasOnAProcessorWhateverTheScreen) {
  if (passes::QualityFor(studio_->renderer()) != Quality::kBasic)
    GTEST_SKIP() << studio_->renderer() << " is no processor, and what it chooses depends on how fast it is";
  ScreenOfSize large(2560, 1440);
  stage::QualityForScreens(*studio_, "auto").See(large);
  EXPECT_EQ(studio_->quality(), Quality::kBasic);
}

// As on a card that drew finely at the usual size: what a processor draws at a larger one is not in time.
TEST_F(QualityChoiceTest, IsLowerForALargerScreenAndAsBeforeForTheOthers) {
  ASSERT_TRUE(studio_->SetQuality(Quality::kFine));
  stage::QualityForScreens sizes(*studio_, "auto"), as_asked(*studio_, "fine");
  ScreenOfSize usual(1920, 1080), large(2560, 1440);
  as_asked.See(large);
  EXPECT_EQ(studio_->quality(), Quality::kFine);
  if (passes::QualityFor(studio_->renderer()) != Quality::kBasic)
    GTEST_SKIP() << studio_->renderer() << " may be fast enough";
  ::testing::internal::CaptureStderr();
  sizes.See(large);
  EXPECT_EQ(studio_->quality(), Quality::kBasic);
  sizes.See(usual);
  EXPECT_EQ(studio_->quality(), Quality::kFine);
  sizes.See(large);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              ::testing::MatchesRegex(
                  "[^\n]*quality basic: fine would take [0-9]+ ms a frame at 2560 x 1440 pixels\n"))
      << "it is timed once";
}

using Times = std::vector<Duration>;
constexpr std::array kBoth{Quality::kFinest, Quality::kFine};

TEST(TheFirstQualityInTime, IsTheFinestThatIs) {
  const auto chosen = stage::FirstInTime(kBoth, [](Quality) -> Result<Times> {
    return Times{3ms, 4ms, 5ms};
  });
  EXPECT_EQ(chosen.quality, Quality::kFinest);
  EXPECT_EQ(chosen.why, "finest, 3.0 ms a frame");
}

TEST(TheFirstQualityInTime, LeavesOutWhatTheDriverRefuses) {
  const auto chosen = stage::FirstInTime(kBoth, [](Quality quality) -> Result<Times> {
    if (quality == Quality::kFinest) return Fail(std::errc::not_supported, "make a shader");
    return Times{3ms};
  });
  EXPECT_EQ(chosen.quality, Quality::kFine);
}

TEST(TheFirstQualityInTime, IsBasicWhereNoneIsAndSaysWhy) {
  const auto slow = stage::FirstInTime(kBoth, [](Quality) -> Result<Times> { return Times{30ms, 40ms}; });
  EXPECT_EQ(slow.quality, Quality::kBasic);
  EXPECT_EQ(slow.why, "basic: fine would take 30 ms a frame");
  const auto refused = stage::FirstInTime(
      kBoth, [](Quality) -> Result<Times> { return Fail(std::errc::not_supported, "make a shader"); });
  EXPECT_THAT(refused.why, ::testing::HasSubstr("basic: fine was refused (make a shader"));
}

TEST(FramesInTime, AreJudgedByTheirMedian) {
  EXPECT_TRUE(stage::IsInTime(std::array<Duration, 3>{3ms, 90ms, 4ms})) << "one hiccup is no slow card";
  EXPECT_FALSE(stage::IsInTime(std::array<Duration, 3>{3ms, 12ms, 13ms}));
  EXPECT_FALSE(stage::IsInTime({}));
}

}  // namespace
}  // namespace kaori::tests
