// The line check on a stage: who begins and ends it, and that nothing of it is played.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/board/caller.h"
#include "appliance/core/board/keys.h"
#include "appliance/core/board/lines.h"
#include "appliance/core/board/press_log.h"
#include "appliance/programs/stage/service_display.h"
#include "appliance/programs/stage/stage.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using board::CallVerb;
using board::LineCheckCall;
using board::LineCheckPhase;
using board::SourceState;
using ::testing::HasSubstr;

class StageLineCheck : public PackTest {
 protected:
  StageLineCheck()
      : board_(board::Board::Create((folder_ / "board").string()).value()),
        surface_writer_(board_.AcquireWriter<board::Surface>().value()),
        stick_writer_(board_.AcquireWriter<board::Stick>(0).value()),
        keys_writer_(board_.AcquireWriter<board::Keys>().value()),
        lines_writer_(board_.AcquireWriter<board::Lines>().value()),
        caller_(board::Caller::Acquire(board_, board::CallWriter::kControl).value()) {
    show::Show show = SmallShow();
    for (std::uint16_t i = 0; i < 4; ++i) show.buttons[i] = {show::CallKind::kFace, i};
    show::Track(show);
    studio_ = stage::Studio::Open(std::move(show)).value();
    clock_.Advance(100s);
    Key(true);
    Write();
    stage_ = std::make_unique<stage::Stage>(board_, stage::StageWriters::Acquire(board_).value(), *studio_,
                                            clock_);
    Run(1s);
  }

  void Key(bool on) { lines_.active = on ? 1U << unsigned(board::Line::kService) : 0; }
  void Write() {
    surface_writer_.Write(surface_, clock_.now(), SourceState::kLive);
    stick_writer_.Write(stick_, clock_.now(), SourceState::kLive);
    keys_writer_.Write(keys_, clock_.now(), SourceState::kLive);
    lines_writer_.Write(lines_, clock_.now(), SourceState::kLive);
  }
  void Run(Duration time) {
    for (const Time end = clock_.now() + time; clock_.now() < end;) {
      Write();
      clock_.Advance(20ms);
      stage_->StepUnseen();
    }
  }
  void Call(CallVerb verb, std::uint32_t subject) {
    caller_.Make({.at = clock_.now(), .verb = verb, .subject = subject});
    Run(20ms);
  }
  void Call(LineCheckCall what) { Call(CallVerb::kLineCheck, static_cast<std::uint32_t>(what)); }
  void Strike(std::size_t usage) {
    board::NotePress(keys_, usage, clock_.now());
    Run(20ms);
  }
  board::LineCheck Check() const { return board_.Read<board::LineCheck>().value; }
  const performance::State& state() const { return stage_->state(); }

  ManualClock clock_;
  board::Board board_;
  board::Writer<board::Surface> surface_writer_;
  board::Writer<board::Stick> stick_writer_;
  board::Writer<board::Keys> keys_writer_;
  board::Writer<board::Lines> lines_writer_;
  board::Caller caller_;
  board::Surface surface_;
  board::Stick stick_;
  board::Keys keys_;
  board::Lines lines_;
  std::unique_ptr<stage::Studio> studio_;
  std::unique_ptr<stage::Stage> stage_;
};

TEST_F(StageLineCheck, BeginsByACallWhileTheServiceKeyIsOnAndNotElse) {
  Key(false);
  Call(LineCheckCall::kBegin);
  EXPECT_EQ(Check().phase, LineCheckPhase::kNever);
  Key(true);
  Call(LineCheckCall::kBegin);
  EXPECT_EQ(Check().phase, LineCheckPhase::kRunning);
  EXPECT_EQ(state().calls_refused, 0U) << "the show never hears of it";
  Call(LineCheckCall::kEnd);
  EXPECT_EQ(Check().phase, LineCheckPhase::kEnded);
}

TEST_F(StageLineCheck, BeginsAndEndsByTheKeyHomeAtABoxWithoutAPage) {
  Strike(board::key::kHome);
  EXPECT_EQ(Check().phase, LineCheckPhase::kRunning);
  Strike(board::key::kEnter);
  const board::LineCheck check = Check();
  const auto items = board::ItemsOf(check);
  const auto lamps = std::ranges::find(items, board::CheckedKind::kLamps, &board::CheckedItem::kind);
  ASSERT_NE(lamps, items.end());
  EXPECT_EQ(lamps->state, board::CheckedState::kSeen) << "Enter says that they were lit";
  Strike(board::key::kHome);
  EXPECT_EQ(Check().phase, LineCheckPhase::kEnded);
}

TEST_F(StageLineCheck, MovesNothingOfTheFaceAndTicksAllTheSame) {
  Call(LineCheckCall::kBegin);
  Run(2s);
  const auto face = state().faces.to;
  const auto knobs = state().knobs;
  stick_.x = 1;
  surface_.counts[2] += 100;
  board::NotePress(surface_, 3, clock_.now());
  Call(CallVerb::kCue, board::kCallGo);
  Run(1s);
  EXPECT_EQ(state().faces.to, face);
  EXPECT_EQ(state().knobs, knobs);
  EXPECT_EQ(state().head.yaw_rad, 0);
  EXPECT_EQ(state().cue_run.active, -1) << "a foot that tries the switch plays no cue";
  EXPECT_EQ(state().cue_run.refused, 0U);
  EXPECT_EQ(board::SeenOf(Check()), 2U) << "the button and the service key";
  stick_.x = 0;
  Call(LineCheckCall::kEnd);
  board::NotePress(surface_, 3, clock_.now());
  Run(100ms);
  EXPECT_EQ(state().faces.to, 3) << "and then the show goes on";
}

TEST_F(StageLineCheck, HearsPanicAndBlackoutAllTheSame) {
  Call(LineCheckCall::kBegin);
  Call(CallVerb::kCue, static_cast<std::uint32_t>(show::CueVerb::kBlackout));
  EXPECT_EQ(state().black_called, 1);
}

TEST_F(StageLineCheck, EndsWithTheServiceKeyAndWhenNobodyWorksAtItAnyMore) {
  Call(LineCheckCall::kBegin);
  Key(false);
  Run(40ms);
  EXPECT_EQ(Check().phase, LineCheckPhase::kEnded);
  Key(true);
  Call(LineCheckCall::kBegin);
  Run(100s);
  board::NotePress(surface_, 3, clock_.now());
  Run(100s);
  EXPECT_EQ(Check().phase, LineCheckPhase::kRunning) << "a button was pushed meanwhile";
  Run(21s);
  EXPECT_EQ(Check().phase, LineCheckPhase::kEnded);
}

TEST_F(StageLineCheck, LightsItsLampsInThePlaceOfTheShows) {
  Call(LineCheckCall::kBegin);
  Run(1s);
  EXPECT_EQ(board_.Read<board::Lamps>().value.lit, 0b11111U) << "no button was pushed yet";
  Call(LineCheckCall::kEnd);
  Run(40ms);
  EXPECT_EQ(board_.Read<board::Lamps>().value.lit & 0b1111U, 1U << state().faces.to);
}

TEST_F(StageLineCheck, SaysOnTheScreenHowFarItIsAndWhatIsNext) {
  Call(LineCheckCall::kBegin);
  scene::Scene scene;
  stage::ShowService(board::ReadAll(board_), clock_.now(), scene);
  ASSERT_EQ(scene.caption.lines.size(), 3U);
  EXPECT_THAT(scene.caption.lines[0], HasSubstr("line check: 1 of "));
  EXPECT_EQ(scene.caption.lines[1], "left stick: x not yet seen");
  scene::Scene later;
  stage::ShowService(board::ReadAll(board_), clock_.now() + 600ms, later);
  EXPECT_FALSE(later.caption.shown > 0) << "its stage died";
}

}  // namespace
}  // namespace kaori::tests
