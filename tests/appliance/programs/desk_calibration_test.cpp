// A whole calibration by keys and lamps at the box, in simulated time, with a rendered operator.
#include <algorithm>
#include <cmath>
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/board/lines.h"
#include "appliance/core/board/mouth.h"
#include "tests/appliance/programs/desk_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.

// An operator with green lips, whose mouth has another range than the box expects.
constexpr sim::Rgb kGreen{0.05F, 0.62F, 0.2F};
constexpr sim::Mouth kShut{0.25, 1}, kOpen{0.62, 0.95}, kWide{0.3, 1.14}, kNarrow{0.34, 0.8};

class DeskCalibration : public ::testing::Test {
 protected:
  DeskCalibration() { house_.hand.scene.person.paint = kGreen; }

  void Make(const sim::Mouth& mouth) {
    house_.hand.scene.person.mouth = mouth;
    house_.Play(700ms);  // As long as a person needs to hear and to act.
  }

  void Begin() {
    house_.Hold(LipFixture::kF12, true);
    house_.Play(2100ms);
    house_.Hold(LipFixture::kF12, false);
    house_.Play(300ms);
  }

  void Measure(const sim::Mouth& mouth) {
    Make(mouth);
    house_.Strike(LipFixture::kEnter);
    house_.Play(1300ms);
  }

  void MeasureAll() {
    for (const sim::Mouth& mouth : {kShut, kOpen, kWide, kNarrow}) Measure(mouth);
  }

  // The mean error of the face's mouth, in parts of its range, at the extremes of the operator's mouth.
  double FaceError() {
    double error = 0;
    const auto add = [&](const sim::Mouth& mouth, float open, float wide) {
      Make(mouth);
      const board::Lips seen = house_.Seen();
      const board::MouthPosition position = board::PositionOf(seen);
      error +=
          board::IsUsable(seen) ? std::abs(position.open - open) / 2 + std::abs(position.wide - wide) / 2 : 1;
    };
    add(kShut, 0, 0.5F);
    add(kOpen, 1, 0.38F);  // A little narrower than at rest: 0.05 of this operator's 0.2.
    add(kWide, 0.14F, 1);
    add(kNarrow, 0.24F, 0);
    return error / 4;
  }

  LipFixture house_;
};

TEST_F(DeskCalibration, ByKeysTakesUnderAMinuteAndMakesGreenLipsAndAnotherMouthPlayTheFace) {
  house_.StartLips();
  house_.Play(1s);
  EXPECT_LT(house_.Seen().quality, 0.3F) << "green lips are not seen as blue ones";
  const double before = FaceError();
  const Time began = house_.clock.now();
  Begin();
  ASSERT_EQ(house_.Guide().source, board::SourceState::kLive);
  EXPECT_EQ(house_.Guide().value.step, 0U);
  EXPECT_EQ(house_.Guide().value.captions, 1U);
  MeasureAll();
  EXPECT_EQ(house_.Guide().value.step, 4U) << "all poses are measured";
  house_.Strike(LipFixture::kEnter);
  const double took_s = Seconds(house_.clock.now() - began);
  EXPECT_LT(took_s, 60);
  house_.Play(100ms);
  EXPECT_EQ(house_.Guide().source, board::SourceState::kAbsent);
  const double after = FaceError();
  EXPECT_LT(after, 0.12);
  EXPECT_LT(after, before / 4);
  std::cout << "calibrated in " << took_s << " s; error of the face's mouth " << before << " before, "
            << after << " after\n";
}

TEST_F(DeskCalibration, HelpsAMouthWhosePaintIsKnownToo) {
  house_.hand.scene.person.paint = {0.08F, 0.24F, 0.78F};
  house_.StartLips();
  house_.Play(1500ms);
  const double before = FaceError();
  Begin();
  MeasureAll();
  EXPECT_LT(FaceError(), before / 2);
}

TEST_F(DeskCalibration, IsSavedAndUsedAfterARestart) {
  house_.StartLips();
  Begin();
  MeasureAll();
  house_.Strike(LipFixture::kEnter);
  house_.Play(100ms);
  ASSERT_TRUE(house_.AwaitSaved());
  ASSERT_TRUE(lips::ReadGenerations(house_.settings_file()).now);
  house_.StartLips();
  house_.Play(500ms);
  EXPECT_GT(house_.Seen().quality, 0.8F) << "green is known";
  EXPECT_NEAR(house_.Seen().open, 0.95 * kOpen.height, 0.03);
}

TEST_F(DeskCalibration, RestoresTheSettingsAfterEscapeAndAfterAMinuteWithoutInput) {
  for (const bool escapes : {true, false}) {
    house_.StartLips();
    house_.Play(500ms);
    Begin();
    Measure(kShut);
    Measure(kOpen);
    EXPECT_EQ(house_.Guide().value.step, 2U);
    if (escapes) house_.Strike(LipFixture::kEscape);
    house_.Play(escapes ? Duration(100ms) : Duration(61s));
    EXPECT_EQ(house_.Guide().source, board::SourceState::kAbsent);
    EXPECT_EQ(house_.Seen().open, lips::Extents{}.open);
    EXPECT_FALSE(std::filesystem::exists(house_.settings_file()));
    house_.hand.scene.person.mouth = kShut;
  }
}

TEST_F(DeskCalibration, ConfirmsPosesByAnyPushOnTheDialBox) {
  house_.StartLips();
  house_.Play(500ms);
  Begin();
  Make(kShut);
  house_.Push(17);
  house_.Play(200ms);
  EXPECT_EQ(house_.Guide().value.taking, 1U);
  EXPECT_GT(house_.Guide().value.progress, 0.0F);
  house_.Push(3);  // A push meanwhile does nothing.
  house_.Play(1200ms);
  EXPECT_EQ(house_.Guide().value.step, 1U);
  EXPECT_EQ(house_.Guide().value.taking, 0U);
}

TEST_F(DeskCalibration, WaitsForAMouthThatIsNotSeen) {
  house_.StartLips();
  house_.Play(500ms);
  Begin();
  Make(kShut);
  house_.hand.scene.light.level = 0;
  house_.Play(200ms);
  house_.Strike(LipFixture::kEnter);
  house_.Play(5s);
  EXPECT_EQ(house_.Guide().value.step, 0U);
  EXPECT_EQ(house_.Guide().value.seen, 0U);
  house_.hand.scene.light.level = 1;
  house_.Play(1500ms);
  EXPECT_EQ(house_.Guide().value.step, 1U);
}

TEST_F(DeskCalibration, BeginsByNoShortPushAndNotAgainWhileTheKeyIsHeld) {
  house_.StartLips();
  house_.Hold(LipFixture::kF12, true);
  house_.Play(1500ms);
  house_.Hold(LipFixture::kF12, false);
  house_.Play(2s);
  EXPECT_FALSE(house_.lips->guide().active());
  house_.Hold(LipFixture::kF12, true);
  house_.Play(2500ms);
  EXPECT_TRUE(house_.lips->guide().active());
  house_.Strike(LipFixture::kEscape);
  house_.Play(3s);
  EXPECT_FALSE(house_.lips->guide().active());
}

TEST_F(DeskCalibration, BeginsByInsertWhereABrowserKeepsF12) {
  house_.StartLips();
  house_.Hold(0x49, true);
  house_.Play(2100ms);
  EXPECT_TRUE(house_.lips->guide().active());
}

TEST_F(DeskCalibration, ShowsCaptionsWhileTheKeySwitchIsOn) {
  auto lines = house_.board.AcquireWriter<board::Lines>().value();
  house_.StartLips(/*service=*/false);
  house_.Play(2s);
  house_.Hold(LipFixture::kF12, true);
  house_.Play(2500ms);
  ASSERT_EQ(house_.Guide().source, board::SourceState::kLive);
  for (const std::uint32_t on : {1U, 0U}) {
    lines.Write({.active = on << static_cast<unsigned>(board::Line::kService)}, house_.clock.now(),
                board::SourceState::kLive);
    house_.Play(50ms);
    EXPECT_EQ(house_.Guide().value.captions, on);
  }
}

TEST_F(DeskCalibration, WorksByLampsAloneOutOfService) {
  house_.StartLips(false);
  house_.Play(500ms);
  Begin();
  EXPECT_EQ(house_.Guide().source, board::SourceState::kLive);
  EXPECT_EQ(house_.Guide().value.captions, 0U) << "nothing is written on a show";
  EXPECT_FALSE(std::filesystem::exists(lips::ServicePath(house_.board.path()))) << "no desk may connect";
}

}  // namespace
}  // namespace kaori::tests
