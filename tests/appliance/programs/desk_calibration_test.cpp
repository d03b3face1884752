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
  DeskCalibration() { fixture_.hand.scene.person.paint = kGreen; }

  void Make(const sim::Mouth& mouth) {
    fixture_.hand.scene.person.mouth = mouth;
    fixture_.Play(700ms);  // As long as a person needs to hear and to act.
  }

  void Begin() {
    fixture_.Hold(LipFixture::kF12, true);
    fixture_.Play(2100ms);
    fixture_.Hold(LipFixture::kF12, false);
    fixture_.Play(300ms);
  }

  void Measure(const sim::Mouth& mouth) {
    Make(mouth);
    fixture_.Strike(LipFixture::kEnter);
    fixture_.Play(1300ms);
  }

  void MeasureAll() {
    for (const sim::Mouth& mouth : {kShut, kOpen, kWide, kNarrow}) Measure(mouth);
  }

  // The mean error of the face's mouth, in parts of its range, at the extremes of the operator's mouth.
  double FaceError() {
    double error = 0;
    const auto add = [&](const sim::Mouth& mouth, float open, float wide) {
      Make(mouth);
      const board::Lips seen = fixture_.Seen();
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

  LipFixture fixture_;
};

TEST_F(DeskCalibration, ByKeysTakesUnderAMinuteAndMakesGreenLipsAndAnotherMouthPlayTheFace) {
  fixture_.StartLips();
  fixture_.Play(1s);
  EXPECT_LT(fixture_.Seen().quality, 0.3F) << "green lips are not seen as blue ones";
  const double before = FaceError();
  const Time began = fixture_.clock.now();
  Begin();
  ASSERT_EQ(fixture_.Guide().source, board::SourceState::kLive);
  EXPECT_EQ(fixture_.Guide().value.step, 0U);
  EXPECT_EQ(fixture_.Guide().value.captions, 1U);
  MeasureAll();
  EXPECT_EQ(fixture_.Guide().value.step, 4U) << "all poses are measured";
  fixture_.Strike(LipFixture::kEnter);
  const double took_s = Seconds(fixture_.clock.now() - began);
  EXPECT_LT(took_s, 60);
  fixture_.Play(100ms);
  EXPECT_EQ(fixture_.Guide().source, board::SourceState::kAbsent);
  const double after = FaceError();
  EXPECT_LT(after, 0.12);
  EXPECT_LT(after, before / 4);
  std::cout << "calibrated in " << took_s << " s; error of the face's mouth " << before << " before, "
            << after << " after\n";
}

TEST_F(DeskCalibration, HelpsAMouthWhosePaintIsKnownToo) {
  fixture_.hand.scene.person.paint = {0.08F, 0.24F, 0.78F};
  fixture_.StartLips();
  fixture_.Play(1500ms);
  const double before = FaceError();
  Begin();
  MeasureAll();
  EXPECT_LT(FaceError(), before / 2);
}

TEST_F(DeskCalibration, IsSavedAndUsedAfterARestart) {
  fixture_.StartLips();
  Begin();
  MeasureAll();
  fixture_.Strike(LipFixture::kEnter);
  fixture_.Play(100ms);
  ASSERT_TRUE(fixture_.AwaitSaved());
  ASSERT_TRUE(lips::ReadGenerations(fixture_.settings_file()).now);
  fixture_.StartLips();
  fixture_.Play(500ms);
  EXPECT_GT(fixture_.Seen().quality, 0.8F) << "green is known";
  EXPECT_NEAR(fixture_.Seen().open, 0.95 * kOpen.height, 0.03);
}

TEST_F(DeskCalibration, RestoresTheSettingsAfterEscapeAndAfterAMinuteWithoutInput) {
  for (const bool escapes : {true, false}) {
    fixture_.StartLips();
    fixture_.Play(500ms);
    Begin();
    Measure(kShut);
    Measure(kOpen);
    EXPECT_EQ(fixture_.Guide().value.step, 2U);
    if (escapes) fixture_.Strike(LipFixture::kEscape);
    fixture_.Play(escapes ? Duration(100ms) : Duration(61s));
    EXPECT_EQ(fixture_.Guide().source, board::SourceState::kAbsent);
    EXPECT_EQ(fixture_.Seen().open, lips::Extents{}.open);
    EXPECT_FALSE(std::filesystem::exists(fixture_.settings_file()));
    fixture_.hand.scene.person.mouth = kShut;
  }
}

TEST_F(DeskCalibration, ConfirmsPosesByAnyPushOnTheDialBox) {
  fixture_.StartLips();
  fixture_.Play(500ms);
  Begin();
  Make(kShut);
  fixture_.Push(17);
  fixture_.Play(200ms);
  EXPECT_EQ(fixture_.Guide().value.taking, 1U);
  EXPECT_GT(fixture_.Guide().value.progress, 0.0F);
  fixture_.Push(3);  // A push meanwhile does nothing.
  fixture_.Play(1200ms);
  EXPECT_EQ(fixture_.Guide().value.step, 1U);
  EXPECT_EQ(fixture_.Guide().value.taking, 0U);
}

TEST_F(DeskCalibration, WaitsForAMouthThatIsNotSeen) {
  fixture_.StartLips();
  fixture_.Play(500ms);
  Begin();
  Make(kShut);
  fixture_.hand.scene.light.level = 0;
  fixture_.Play(200ms);
  fixture_.Strike(LipFixture::kEnter);
  fixture_.Play(5s);
  EXPECT_EQ(fixture_.Guide().value.step, 0U);
  EXPECT_EQ(fixture_.Guide().value.seen, 0U);
  fixture_.hand.scene.light.level = 1;
  fixture_.Play(1500ms);
  EXPECT_EQ(fixture_.Guide().value.step, 1U);
}

TEST_F(DeskCalibration, BeginsByNoShortPushAndNotAgainWhileTheKeyIsHeld) {
  fixture_.StartLips();
  fixture_.Hold(LipFixture::kF12, true);
  fixture_.Play(1500ms);
  fixture_.Hold(LipFixture::kF12, false);
  fixture_.Play(2s);
  EXPECT_FALSE(fixture_.lips->guide().active());
  fixture_.Hold(LipFixture::kF12, true);
  fixture_.Play(2500ms);
  EXPECT_TRUE(fixture_.lips->guide().active());
  fixture_.Strike(LipFixture::kEscape);
  fixture_.Play(3s);
  EXPECT_FALSE(fixture_.lips->guide().active());
}

TEST_F(DeskCalibration, BeginsByInsertWhereABrowserKeepsF12) {
  fixture_.StartLips();
  fixture_.Hold(0x49, true);
  fixture_.Play(2100ms);
  EXPECT_TRUE(fixture_.lips->guide().active());
}

TEST_F(DeskCalibration, ShowsCaptionsWhileTheKeySwitchIsOn) {
  auto lines = fixture_.board.AcquireWriter<board::Lines>().value();
  fixture_.StartLips(/*service=*/false);
  fixture_.Play(2s);
  fixture_.Hold(LipFixture::kF12, true);
  fixture_.Play(2500ms);
  ASSERT_EQ(fixture_.Guide().source, board::SourceState::kLive);
  for (const std::uint32_t on : {1U, 0U}) {
    lines.Write({.active = on << static_cast<unsigned>(board::Line::kService)}, fixture_.clock.now(),
                board::SourceState::kLive);
    fixture_.Play(50ms);
    EXPECT_EQ(fixture_.Guide().value.captions, on);
  }
}

TEST_F(DeskCalibration, WorksByLampsAloneOutOfService) {
  fixture_.StartLips(false);
  fixture_.Play(500ms);
  Begin();
  EXPECT_EQ(fixture_.Guide().source, board::SourceState::kLive);
  EXPECT_EQ(fixture_.Guide().value.captions, 0U) << "nothing is written on a show";
  EXPECT_FALSE(std::filesystem::exists(lips::ServicePath(fixture_.board.path()))) << "no desk may connect";
}

TEST_F(DeskCalibration, LetsADeskConnectForAsLongAsTheKeyIsOn) {
  const auto connectable = [&] { return std::filesystem::exists(lips::ServicePath(fixture_.board.path())); };
  fixture_.StartLips(false);
  auto lines = fixture_.board.AcquireWriter<board::Lines>().value();
  const auto turn = [&](bool on) {
    board::Lines state;
    if (on) state.active |= 1U << static_cast<unsigned>(board::Line::kService);
    lines.Write(state, fixture_.clock.now(), board::SourceState::kLive);
    fixture_.Play(100ms);
  };
  turn(false);
  EXPECT_FALSE(connectable());
  turn(true);
  EXPECT_TRUE(connectable());
  turn(false);
  EXPECT_FALSE(connectable());
}

}  // namespace
}  // namespace kaori::tests
