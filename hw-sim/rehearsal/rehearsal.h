// The whole system in one process on a simulated clock: simulated devices, real drivers, board, stage. The
// same input gives the same board and the same pictures every time. For films, golden pictures and tests.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/input_service.h"
#include "appliance/programs/lips/lip_reader.h"
#include "appliance/programs/lips/service/monitor_picture.h"
#include "appliance/programs/lips/voice/voice_service.h"
#include "appliance/programs/stage/stage.h"
#include "appliance/programs/stage/stage_monitor.h"
#include "appliance/programs/stage/stage_status_display.h"
#include "appliance/programs/stage/studio.h"
#include "drivers/base/clock.h"
#include "drivers/hid/local_bus.h"
#include "hw-sim/links/local/rig.h"

namespace kaori::sim {

// How the simulated system is set up. Each value is the simulator's own; the
// programs learn it from the devices.
struct RehearsalOptions {
  // Where the board and the links lie; made if it is not there.
  std::string folder;
  // Of the screen and of the pictures.
  int width_px = 960;
  int height_px = 540;
  // Of the screen.
  double hz = 30;
  // Of the lip camera.
  double camera_hz = 30;
  // None: as measured.
  voice::DelaySetting sound_delay{};
  // Of its pictures; even sides.
  int camera_width_px = 640;
  int camera_height_px = 480;
  // Reports leave no more often.
  Duration tick = std::chrono::milliseconds(1);
};

// What may end and start again while the others play on.
enum class Program : std::uint8_t { kInput, kLips, kStage };

// The programs of the box run in this one thread, step by step, in place of processes that wait in
// loops: what would be a race on a box has one order here. One thread.
class Rehearsal {
 public:
  // Plugs every device in and waits, in simulated time, until each has its slot. The studio outlives it and
  // may serve one rehearsal after another. Errors: those of the folder, the board, the sockets; timed_out
  // when a device had no slot within a simulated second.
  static Result<std::unique_ptr<Rehearsal>> Open(const RehearsalOptions& options, stage::Studio& studio);
  ~Rehearsal();

  // What operators do at each moment; called once a millisecond of simulated time, before the devices speak.
  using Input = std::function<void(Time now)>;

  // Moves time to the next vertical blank at which a new picture is presented, and gives that picture.
  // Takes as long as drawing it does. The picture is borrowed until the next call. Errors: timed_out
  // when no picture came within a simulated second.
  Result<Shown> NextPicture(const Input& input = {});

  // Moves time on by one tick: operators, devices, programs. What is gone is looked for as often as the
  // programs' own loops do: a screen four times a second, the board's file as often.
  void Step(const Input& input);

  // Ends a program: what it had of the board and of the devices is free. One that does not run stays so. May
  // be called by an Input.
  void End(Program program);
  // Starts it again as its main does; it goes on from what the board holds. One that runs stays as it is.
  // Errors: as Open.
  Result<void> Start(Program program);
  // The whole machine does nothing for so long: what falls due meanwhile is late.
  void StandStill(Duration length) { clock_.Advance(length); }

  // Called after each frame that the screen has accepted, of this stage and of those that start after it.
  void CallAfterFrames(stage::Stage::AfterFrame after);

  // Lets operators make expressions. The editor was opened on the studio's show. To
  // be called before the first picture.
  void Bring(std::unique_ptr<editor::ExpressionEditor> editor) { stage_->SetEditor(std::move(editor)); }

  // Draws the operators' monitor on this display from now on, which outlives the rehearsal; null: no longer.
  // Its time of day begins at `began`, in seconds of the system's clock, and goes with the simulated one.
  void ShowMonitor(ports::SideDisplay* display, std::time_t began);

  // Notes each frame from the next one on, over restarts of the stage; the recorder outlives the rehearsal,
  // or null is set before.
  void SetLog(showlog::Recorder* log);

  // The test's side of every device.
  Rig& rig() { return *rig_; }
  // What the programs have written; valid as long as the rehearsal.
  const board::Board& board() const { return board_; }
  const stage::Stage& stage() const { return *stage_; }
  Time now() const { return clock_.now(); }
  Time began() const { return began_; }  // When every device had its slot and the first picture was shown.

 private:
  Rehearsal(RehearsalOptions options, stage::Studio& studio, board::Board board,
            std::unique_ptr<ports::HidBus> bus)
      : options_(std::move(options)), studio_(studio), board_(std::move(board)), bus_(std::move(bus)) {}
  // Plugs the devices in and starts all programs. Errors: as Open.
  Result<void> OpenParts();
  // Each starts one. Errors: as Open.
  Result<void> StartInput();
  Result<void> StartLips();
  Result<void> StartStage();
  // Connects to the panel and has it answer. Errors: those of LocalLines.
  Result<std::unique_ptr<ports::GpioLines>> OpenLines();
  // The microphone and the loudspeaker; the sounds are those of the show's motions. Errors: as Open.
  Result<void> OpenVoice();
  // Steps until every device has its slot and a picture is shown.
  Result<void> Settle();
  // The stage with its screen, or unseen while there is none (stage::ScreenSession).
  void StepStage();
  void LookForScreen();
  // As board::Watch.
  void WatchBoard();
  // The displays beside the stage, as its main steps them.
  void StepMonitor();

  RehearsalOptions options_;
  stage::Studio& studio_;
  // Before all that borrows it. Members end in reverse order: the stage first, the devices last.
  ManualClock clock_;
  board::Board board_;
  std::unique_ptr<ports::HidBus> bus_;
  std::unique_ptr<Rig> rig_;
  std::unique_ptr<input::InputService> input_;
  std::unique_ptr<lips::LipReader> lips_;
  std::unique_ptr<voice::VoiceService> voice_;
  std::unique_ptr<stage::Stage> stage_;
  // The folder of the local link.
  std::string links_;
  // Since ShowMonitor.
  ports::SideDisplay* monitor_display_ = nullptr;
  std::unique_ptr<stage::StageStatusDisplay> status_;
  std::unique_ptr<stage::StageMonitor> monitor_;
  Time monitor_step_{};
  std::optional<lips::MonitorPicture> lip_picture_;
  showlog::Recorder* log_ = nullptr;
  stage::Stage::AfterFrame after_frame_;
  // When each is due again.
  Time screen_look_{}, unseen_step_{}, board_look_{};
  Time began_{};
};

}  // namespace kaori::sim
