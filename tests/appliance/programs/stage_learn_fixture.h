// A stage that is taught, with the devices and the file of roles that it needs.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "appliance/core/board/caller.h"
#include "appliance/core/board/lines.h"
#include "appliance/core/board/press_log.h"
#include "appliance/programs/stage/chosen_show.h"
#include "appliance/programs/stage/stage.h"
#include "drivers/base/read_file.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {

class StageLearn : public PackTest {
 protected:
  StageLearn()
      : board_(board::Board::Create((folder_ / "board").string()).value()),
        surface_writer_(board_.AcquireWriter<board::Surface>().value()),
        stick_writer_(board_.AcquireWriter<board::Stick>(0).value()),
        keys_writer_(board_.AcquireWriter<board::Keys>().value()),
        lines_writer_(board_.AcquireWriter<board::Lines>().value()),
        caller_(board::Caller::Acquire(board_, board::CallWriter::kControl).value()) {
    clock_.Advance(std::chrono::seconds(100));
    Key(true);
    Write();
    StartStage();
  }

  // As the program does it: with the box's own roles over the show's.
  void StartStage() {
    stage_.reset();
    show::Show show = SmallShow();
    show::Track(show);
    auto own = stage::OwnRolesOver(show, file_);
    stage::LayOverRoles(own, show);
    studio_ = stage::Studio::Open(std::move(show)).value();
    stage_ = std::make_unique<stage::Stage>(board_, stage::StageWriters::Acquire(board_).value(), *studio_,
                                            clock_);
    stage_->LetTeach(std::move(own));
    Run(std::chrono::seconds(1));
  }
  void StartAgain() {
    ASSERT_NE(stage_->taught(), nullptr);
    stage_->HandOver(*stage_->taught());
    StartStage();
    EXPECT_TRUE(stage_->resumed());
  }
  void Key(bool on) { lines_.active = on ? 1U << unsigned(board::Line::kService) : 0; }
  void Write() {
    surface_writer_.Write(surface_, clock_.now(), board::SourceState::kLive);
    stick_writer_.Write(stick_, clock_.now(), board::SourceState::kLive);
    keys_writer_.Write(keys_, clock_.now(), board::SourceState::kLive);
    lines_writer_.Write(lines_, clock_.now(), board::SourceState::kLive);
  }
  void Run(Duration time) {
    for (const Time end = clock_.now() + time; clock_.now() < end;) {
      Write();
      clock_.Advance(std::chrono::milliseconds(20));
      stage_->StepUnseen();
    }
  }
  void Call(board::LearnCall what, std::uint32_t choice = 0) {
    caller_.Make({.at = clock_.now(),
                  .verb = board::CallVerb::kLearn,
                  .subject = static_cast<std::uint32_t>(what),
                  .value = static_cast<float>(choice)});
    Run(std::chrono::milliseconds(20));
  }
  void Begin(show::Level level) { Call(board::LearnCall::kBegin, static_cast<std::uint32_t>(level)); }
  void Keep() {
    Call(board::LearnCall::kKeep);
    AwaitTheDisk();
  }
  // Which is written by a thread of its own.
  void AwaitTheDisk() {
    for (int i = 0; i < 1000 && Now().phase == board::LearnPhase::kKeeping; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      Run(std::chrono::milliseconds(20));
    }
  }
  void Strike(std::size_t usage) {
    board::NotePress(keys_, usage, clock_.now());
    Run(std::chrono::milliseconds(20));
  }
  void Twist(float to) {
    Run(std::chrono::milliseconds(400));
    stick_.twist = to;
    Run(std::chrono::milliseconds(700));
    stick_.twist = 0;
    Run(std::chrono::seconds(1));
  }
  board::Learn Now() const { return board_.Read<board::Learn>().value; }
  float Value(show::Level level) const {
    return stage_->state().levels[static_cast<std::size_t>(level)].value;
  }
  std::string File() const { return ReadFile(file_).value_or(""); }

  std::filesystem::path file_ = folder_ / "own" / "roles.toml";
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

}  // namespace kaori::tests
