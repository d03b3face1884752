// The whole system in one process on a simulated clock: simulated devices, real drivers, board, stage. The same input gives
// the same board and the same pictures every time. For films, golden pictures and tests.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/input_service.h"
#include "appliance/programs/lips/lip_reader.h"
#include "appliance/programs/lips/voice/voice_service.h"
#include "appliance/programs/stage/stage.h"
#include "appliance/programs/stage/studio.h"
#include "drivers/base/clock.h"
#include "drivers/hid/local_bus.h"
#include "hw-sim/links/local/rig.h"

namespace kaori::sim {

// How the simulated system is set up. Each value is the simulator's own; the
// programs learn it from the devices.
struct RehearsalOptions {
  std::string folder;  // Where the board and the links lie; made if it is not there.
  // Of the screen and of the pictures.
  int width_px = 960;
  int height_px = 540;
  double hz = 30;                     // Of the screen.
  double camera_hz = 30;              // Of the lip camera.
  voice::DelaySetting sound_delay{};  // None: as measured.
};

// The programs of the box run in this one thread, step by step, in place of processes that wait in
// loops: what would be a race on a box has one order here. One thread.
class Rehearsal {
 public:
  // Plugs every device in and waits, in simulated time, until each has its slot. The studio outlives it and may serve one
  // rehearsal after another. Errors: those of the folder, the board, the sockets; timed_out when a device had no slot within
  // a simulated second.
  static Result<std::unique_ptr<Rehearsal>> Open(const RehearsalOptions& options, stage::Studio& studio);
  ~Rehearsal();

  // What operators do at each moment; called once a millisecond of simulated time, before the devices speak.
  using Input = std::function<void(Time now)>;

  // Moves time to the next vertical blank at which a new picture is presented, and gives that picture.
  // Takes as long as drawing it does. The picture is borrowed until the next call. Errors: timed_out
  // when no picture came within a simulated second.
  Result<Shown> NextPicture(const Input& input = {});

  // Lets operators make expressions. The editor was opened on the studio's show. To
  // be called before the first picture.
  void Bring(std::unique_ptr<editor::ExpressionEditor> editor) { stage_->SetEditor(std::move(editor)); }

  // Notes each frame from the next one on; the recorder outlives the rehearsal, or null is set before.
  void SetLog(showlog::Recorder* log) { stage_->SetLog(log); }

  // The test's side of every device.
  Rig& rig() { return *rig_; }
  // What the programs have written; valid as long as the rehearsal.
  const board::Board& board() const { return board_; }
  const stage::Stage& stage() const { return *stage_; }
  Time now() const { return clock_.now(); }
  Time began() const { return began_; }  // When every device had its slot and the first picture was shown.

 private:
  Rehearsal(board::Board board, std::unique_ptr<ports::HidBus> bus)
      : board_(std::move(board)), bus_(std::move(bus)) {}
  // Each opens its part of Open. Errors: as Open.
  Result<void> OpenParts(const RehearsalOptions& options, stage::Studio& studio);
  // Connects to the panel and has it answer. Errors: those of LocalLines.
  Result<std::unique_ptr<ports::GpioLines>> OpenLines();
  // The microphone and the loudspeaker; the sounds are those of the show's motions. Errors: as Open.
  Result<void> OpenVoice(const RehearsalOptions& options, const show::Show& show);
  // Steps until every device has its slot and a picture is shown.
  Result<void> Settle();
  void Tick(const Input& input);  // One simulated millisecond.

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
  Time began_{};
};

}  // namespace kaori::sim
