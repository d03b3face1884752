// The stage: reads the board as late as the frame allows, animates, draws, and presents. One frame is in
// three times: the input is sampled at plan.begin, the animation is asked for plan.presented_at, and the flip
// says when it really was presented.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/animate.h"
#include "appliance/core/showlog/minus_one.h"
#include "appliance/core/showlog/recorder.h"
#include "appliance/programs/editor/expression_editor.h"
#include "appliance/programs/stage/act_clock.h"
#include "appliance/programs/stage/call_log.h"
#include "appliance/programs/stage/frame_pacer.h"
#include "appliance/programs/stage/local_time.h"
#include "appliance/programs/stage/mouth_clock.h"
#include "appliance/programs/stage/service_modes.h"
#include "appliance/programs/stage/studio.h"
#include "drivers/base/clock.h"
#include "drivers/ports/scanout.h"

namespace kaori::stage {

// What the stage writes to the board. Who holds these is the one stage of the machine.
struct StageWriters {
  board::Writer<board::Performance> performance;
  board::Writer<board::Lamps> lamps;
  board::Writer<board::StageStatus> status;
  board::Writer<board::ShowNow> show_now;
  board::Writer<board::MotionNow> motion_now;
  board::Writer<board::LineCheck> line_check;
  board::Writer<board::Learn> learn;
  board::Writer<board::ButtonCalls> button_calls;

  // Errors: as Board::AcquireWriter; a second stage is refused.
  static Result<StageWriters> Acquire(const board::Board& board);
};

// One thread. The board, the studio and the clock must outlive it. Nothing of it waits for a screen, a disk
// or another program; the one wait of the process is in its event loop.
class Stage {
 public:
  // Goes on from the state that an earlier stage left on the board, if that is valid. Else it opens the
  // show's first scene. Draws nothing yet.
  Stage(const board::Board& board, StageWriters writers, Studio& studio, const Clock& clock);

  // Lets an author make expressions in the show. `editor` was opened on the studio's show. To be called
  // before the first Step.
  void SetEditor(std::unique_ptr<editor::ExpressionEditor> editor) { editor_ = std::move(editor); }
  const editor::ExpressionEditor* expression_editor() const { return editor_.get(); }

  // From the next frame on each is noted there, seen or not. The recorder outlives the stage; null: no
  // longer.
  void SetLog(showlog::Recorder* log) { log_ = log; }
  // Where a lobby's opening hours come from; see LocalTime::Set.
  void SetLocalTime(std::function<std::int32_t()> week_minute) { local_time_.Set(std::move(week_minute)); }
  // Lines over the picture from the next frame on, for whoever services the box; none in a show.
  void SetNotice(const std::vector<std::string>& lines) {
    if (lines != notice_) notice_ = lines;
  }

  // Plays an evening again from its log, from the next frame on, without the part of one operator, which is
  // live. When it is over, or where its log has a gap, all of the board is live. The evening was opened on
  // the studio's show.
  void PlayOver(std::unique_ptr<showlog::MinusOne> evening) { evening_ = std::move(evening); }

  // Called after each frame that the screen has accepted; until it returns the next one waits.
  using AfterFrame = std::function<void(const performance::State&, const scene::Scene&, Time now)>;
  void CallAfterFrames(AfterFrame after) { after_frame_ = std::move(after); }

  // Lets people teach the box's own roles, which lie over those of the show. To be called before the first
  // Step.
  void LetTeach(OwnRoles own) { service_.learner().SetRoles(std::move(own)); }
  // Somebody has taught, and is done: the roles that the next stage plays. Null before; the stage is then to
  // end, and to be told of them.
  const show::Roles* taught() const { return service_.learner().over(); }
  // The next stage goes on from this one's state with other roles: no level is anybody's. No Step follows.
  void HandOver(const show::Roles& next);

  // The screen that shows the frames from now on, owned by the stage; null when it was unplugged.
  void SetScreen(std::unique_ptr<ports::Scanout> screen);
  bool has_screen() const { return screen_ != nullptr; }
  ports::Scanout* screen() const { return screen_.get(); }  // Until the next SetScreen or Step.

  // From now on samples the input as late as each frame allows; before, right after the flip. Step is then to
  // be called at wakes_at() too.
  void SampleLate() { pacer_.Set(true); }

  // Handles the flips that happened, and draws the next frame when the screen has room for it and it is time.
  // Never waits for the screen. A screen that is gone is let go, with a line in the log. To be called when
  // the screen's descriptor is readable and at wakes_at(). A frame takes as long as drawing does; one of them
  // is drawn at most.
  void Step();

  // When the next frame begins, if the screen waits for one; it may have passed.
  std::optional<Time> wakes_at() const;

  // To be called instead while there is no screen: the performance still moves, so that lamps answer and no
  // jump is seen later. Some 30 times a second are enough.
  void StepUnseen();

  // How long a frame usually takes, for the watchdog; 0 before the first. Until 100 were drawn, which may
  // compile shaders, it is so much that the watchdog waits for 20 of the slowest so far, and for ten seconds
  // at least; it never waits for longer than that afterwards.
  Duration usual_turn() const;

  // True where it goes on from the state of an earlier stage.
  bool resumed() const { return resumed_; }
  const performance::State& state() const { return state_; }

 private:
  // Reads all flips that the screen reports. Errors: those of Scanout::ReadFlip but for "later".
  Result<void> HandleFlips();
  // Tells pacer, mouth clock and status of one.
  void NoteFlip(const ports::Flip& flip);
  // Draws the next frame where the screen has room and its time has come.
  Result<void> DrawWhenDue();
  // One frame from the board to Present.
  Result<void> Draw(const ports::PixelBuffer& picture);
  // The board as it is now; holds until the next call.
  const board::Snapshot& ReadBoard(Time now);
  // The performance of this frame, with the editor before it where there is one.
  performance::Performed Animate(const board::Snapshot& snapshot, performance::InputEvents& events,
                                 Time presented_at);
  // What the editor leaves of the board; a show that is locked has no editor.
  const board::Snapshot& PlayEditor(const board::Snapshot& snapshot, performance::InputEvents& events,
                                    Time presented_at);
  // The frame of what is left of the board, noted in the log. `changed`: an editor has changed the state
  // before it.
  performance::Performed AnimateAndNote(const board::Snapshot& snapshot,
                                        const performance::InputEvents& events, Time presented_at,
                                        bool changed);
  // The live board with the evening over it, where one is played; borrowed until the next call.
  const board::Snapshot& WithEvening(const board::Snapshot& live, Time presented_at);
  // Moves the show on to `presented_at`, writes state, motion and lamps to the board, and gives the scene.
  scene::Scene Perform(const board::Snapshot& live, Time presented_at);
  // Writes which motion plays, for its sound.
  void WriteMotionNow(Time presented_at);
  // One line when the age of the lips is known, and when it has become another one.
  void LogLipsAge(Time now);
  // Writes the section stage_status; `cpu` is what this frame took.
  void Report(const board::Snapshot& snapshot, Duration cpu);

  const board::Board& board_;
  board::SnapshotReader snapshots_;
  StageWriters writers_;
  Studio& studio_;
  const Clock& clock_;
  std::unique_ptr<ports::Scanout> screen_;
  std::unique_ptr<editor::ExpressionEditor> editor_;
  ServiceModes service_{writers_.line_check, writers_.learn};
  CallLog call_log_;
  LocalTime local_time_;
  std::optional<ActClock> act_clock_;  // Since the constructor.
  showlog::Recorder* log_ = nullptr;
  std::unique_ptr<showlog::MinusOne> evening_;
  board::Snapshot laid_;  // The board of this frame, where an evening lies over it.
  bool evening_began_ = false;
  std::vector<std::string> notice_;
  // The state of the show, as it was written to the board last.
  performance::State state_;
  bool resumed_ = false;
  FramePacer pacer_;
  std::optional<FramePacer::Plan> plan_;  // Of the frame that is next, once the screen has room for it.
  // Number of the newest frame that was presented, counted from 1 since this stage began.
  std::uint64_t frame_ = 0;
  Duration slowest_turn_{};  // Of all so far.
  // When the input was sampled for that frame.
  Time read_{};
  MouthClock mouth_clock_;
  AfterFrame after_frame_;
  Duration logged_age_{};
  Time age_quiet_until_{};
  // Both as they were written to the board last; they go on from an earlier stage.
  board::MotionNow motion_now_;
  board::StageStatus status_;
  struct Second {  // What is averaged over a second.
    Time began{};
    std::uint32_t frames = 0;
    Duration cpu{};
  } second_;
};

}  // namespace kaori::stage
