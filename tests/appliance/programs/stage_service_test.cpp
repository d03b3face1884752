// What the stage does for whoever works at the box: lamps, lines, and presses that are not played.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/board/press_log.h"
#include "appliance/programs/stage/service_display.h"
#include "appliance/programs/stage/stage.h"
#include "tests/appliance/core/pack_fixture.h"
#include "tests/appliance/programs/stage_screen.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using board::SourceState;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Time kNow = Time{} + 1000s;

board::Snapshot WithGuide(const board::LipsGuide& guide) {
  board::Snapshot snapshot;
  snapshot.lips_guide = {guide, kNow, SourceState::kLive};
  return snapshot;
}

board::Snapshot WithDesk(const board::Desk& desk) {
  board::Snapshot snapshot;
  snapshot.desk = {desk, kNow, SourceState::kLive};
  return snapshot;
}

std::vector<std::string> LinesOf(const board::Snapshot& snapshot, Duration later = {}) {
  scene::Scene scene;
  stage::ShowService(snapshot, kNow + later, scene);
  return scene.caption.shown > 0 ? scene.caption.lines : std::vector<std::string>();
}

constexpr board::Desk kDesk{.code = 4711,
                            .valid_s = 300,
                            .address = 0xC0A80114,
                            .port = 8443,
                            .secure = 1,
                            .certificate = 0x3FA2910C};

TEST(StageService, SaysNothingWhenNobodyWorksAtTheBox) {
  EXPECT_THAT(LinesOf({}), IsEmpty());
  EXPECT_THAT(LinesOf(WithGuide({.step = 1, .seen = 1, .captions = 0})), IsEmpty())
      << "lamps alone lead, out of service";
}

TEST(StageService, ShowsWhereTheDeskIsAndItsCode) {
  EXPECT_THAT(LinesOf(WithDesk(kDesk)),
              ElementsAre("https://192.168.1.20:8443", "code 004 711", "certificate 3F A2 91 0C"));
}

TEST(StageService, ShowsNoCodeOfADeskThatIsSilentOrWhoseCodeIsOver) {
  EXPECT_THAT(LinesOf(WithDesk(kDesk), 2900ms), ::testing::SizeIs(3));
  EXPECT_THAT(LinesOf(WithDesk(kDesk), 3s), IsEmpty());
  board::Desk brief = kDesk;
  brief.valid_s = 1;
  EXPECT_THAT(LinesOf(WithDesk(brief), 1s), IsEmpty());
  board::Snapshot gone = WithDesk(kDesk);
  gone.desk.source = SourceState::kAbsent;
  EXPECT_THAT(LinesOf(gone), IsEmpty());
}

TEST(StageService, LeadsThroughACalibrationInWords) {
  EXPECT_THAT(LinesOf(WithGuide({.step = 0, .seen = 1, .captions = 1})),
              ElementsAre("lips 1 of 4: mouth shut", "Enter takes it   Esc goes back"));
  EXPECT_THAT(LinesOf(WithGuide({.step = 2, .taking = 1, .progress = 0.4F, .seen = 1, .captions = 1})),
              ElementsAre("lips 3 of 4: wide", "hold it ... 40 %"));
  EXPECT_THAT(LinesOf(WithGuide({.step = 3, .taking = 1, .seen = 0, .captions = 1})),
              ElementsAre("lips 4 of 4: narrow", "no mouth is seen"));
  EXPECT_THAT(LinesOf(WithGuide({.step = 4, .seen = 1, .captions = 1})),
              ElementsAre("lips: all is taken", "Enter keeps it   Esc goes back"));
  EXPECT_THAT(LinesOf(WithGuide({.step = 4, .seen = 1, .captions = 1}), 600ms), IsEmpty()) << "the lips died";
}

TEST(StageService, SaysNoCodeInTheMiddleOfACalibration) {
  board::Snapshot both = WithDesk(kDesk);
  both.lips_guide = WithGuide({.step = 4, .seen = 1, .captions = 1}).lips_guide;
  EXPECT_THAT(LinesOf(both), ::testing::SizeIs(2));
}

TEST(StageService, KeepsTheLinesOfTheEditorBesideItsOwn) {
  scene::Scene scene;
  scene.caption = {1, {"mirror on"}};
  stage::ShowService(WithDesk({.code = 1, .valid_s = 9, .address = 1, .port = 80}), kNow, scene);
  EXPECT_THAT(scene.caption.lines, ElementsAre("http://0.0.0.1:80", "code 000 001", "mirror on"));
}

// Which lamps are ever lit, and which always are, within two seconds.
std::pair<std::uint32_t, std::uint32_t> LampsOf(const board::LipsGuide& guide) {
  std::uint32_t ever = 0, always = ~0U;
  for (Duration t{}; t < 2s; t += 10ms) {
    const std::uint32_t lit = stage::GuideLamps(guide, kNow + t);
    ever |= lit;
    always &= lit;
  }
  return {ever, always};
}

TEST(StageService, BlinksTheLampOfThePoseThatIsAskedFor) {
  EXPECT_EQ(LampsOf({.step = 0}), std::pair(0b0001U, 0b0000U));
  EXPECT_EQ(LampsOf({.step = 2}), std::pair(0b0111U, 0b0011U));
  EXPECT_EQ(LampsOf({.step = 2, .taking = 1}), std::pair(0b0111U, 0b0011U));
  EXPECT_EQ(LampsOf({.step = 4}), std::pair(0b1111U, 0b0000U));
}

class StageInService : public PackTest {
 protected:
  StageInService()
      : board_(board::Board::Create((folder_ / "board").string()).value()),
        surface_(board_.AcquireWriter<board::Surface>().value()),
        guide_(board_.AcquireWriter<board::LipsGuide>().value()) {
    show::Show show = SmallShow();
    for (std::uint16_t i = 0; i < 4; ++i) show.buttons[i] = {show::CallKind::kFace, i};
    studio_ = stage::Studio::Open(std::move(show)).value();
    clock_.Advance(100s);
    Push(0);
    stage_ = std::make_unique<stage::Stage>(board_, stage::StageWriters::Acquire(board_).value(), *studio_,
                                            clock_);
  }
  void Push(std::size_t button) {
    board::NotePress(surface_value_, button, clock_.now());
    surface_.Write(surface_value_, clock_.now(), SourceState::kLive);
  }
  void Frame() {
    clock_.Advance(33ms);
    stage_->StepUnseen();
  }

  ManualClock clock_;
  board::Board board_;
  board::Writer<board::Surface> surface_;
  board::Writer<board::LipsGuide> guide_;
  board::Surface surface_value_;
  std::unique_ptr<stage::Studio> studio_;
  std::unique_ptr<stage::Stage> stage_;
};

TEST_F(StageInService, PlaysNoPushThatTakesAPoseAndLightsTheGuidesLamps) {
  Frame();
  const auto face = stage_->state().faces.to;
  guide_.Write({.step = 2, .taking = 1}, clock_.now(), SourceState::kLive);
  Push(3);
  Frame();
  EXPECT_EQ(stage_->state().faces.to, face);
  EXPECT_EQ(board_.Read<board::Lamps>().value.lit & 3U, 3U) << "two poses are taken";
  guide_.Write({}, clock_.now(), SourceState::kAbsent);
  Frame();
  EXPECT_EQ(stage_->state().faces.to, face) << "nor is it played afterwards";
  Push(3);
  Frame();
  EXPECT_EQ(stage_->state().faces.to, 3) << "and then the show goes on";
}

}  // namespace
}  // namespace kaori::tests
