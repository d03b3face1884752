// The last face of a show, kept while the box is off: a small picture, which the box shows at once when it is
// switched on, and the state from which the stage then plays on, so that nothing jumps between the two. The
// file's format is in appliance/core/last_face.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/last_face/show_mark.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"
#include "appliance/programs/stage/studio.h"
#include "drivers/base/result.h"
#include "render/scene/scene.h"

namespace kaori::stage {

// Where it is kept, and of which show (ShowMark). The pack's mark tells that file and show belong together: a
// box with another show starts with that show's own picture.
struct LastFaceFile {
  std::filesystem::path file;
  std::uint64_t show = 0;
};

// By which a show is known.
using last_face::ShowMark;

// The state that was kept, on this board, for a first frame that is presented at `presented_at`. Blocks for
// the disk. Errors:
//   no_such_file_or_directory  none was kept
//   invalid_argument           a torn file, one of another show or another version
// The fades of the kept state are done and its time is `presented_at` (performance::Recalled).
Result<performance::State> RecallLastFace(const LastFaceFile& where, const show::Show& show,
                                          const board::Snapshot& board, Time presented_at);

// Puts the state that was kept onto a board that has none yet, and gives it: a stage that starts then goes on
// from there. Why it cannot be had is one line in the log, but for a box that never kept one. Blocks for the
// disk; called once, before the Stage is made, which then finds the state on the board as it would after a
// crash.
std::optional<performance::State> ResumeLastFace(const LastFaceFile& where, const show::Show& show,
                                                 const board::Board& board,
                                                 board::Writer<board::Performance>& writer,
                                                 Time presented_at);

// Called by the stage's thread; a thread of its own writes. A face is kept within half a minute after a call
// or a dial changed it, once no fade, motion or blink is under way; not in a blackout, nor with words on the
// screen. Of the disk's errors each kind is logged once, and the show goes on. The owner calls KeepNow before
// it ends in order; a stage that is killed loses half a minute at most, and the file is never half written.
// While an update is tried nothing is kept: its face is judged by the one that the system before has kept,
// which greets the audience again where the update gives way.
class LastFace {
 public:
  // Copies out what is on the screen; false where there is nothing. Called on the stage's thread; it may wait
  // for the graphics card.
  using Look = std::function<bool(SmallImage&)>;
  // Whether this system is tried, and has not been confirmed yet. Asked when there is something to be kept,
  // once a second at most.
  using IsOnTrial = std::function<bool()>;

  // `recalled` is what lies there already, so that it is not written again; empty where there is nothing.
  LastFace(LastFaceFile where, Look look, IsOnTrial is_on_trial,
           const std::optional<performance::State>& recalled);
  // Waits for the disk.
  ~LastFace();
  LastFace(const LastFace&) = delete;
  LastFace& operator=(const LastFace&) = delete;

  // To be called after each frame, with what it showed. Allocates the first time only; waits for no disk, and
  // for the picture twice a minute at most.
  void Observe(const performance::State& state, const scene::Scene& scene, Time now);

  // Keeps what was observed last, however new, and waits for the disk: for an orderly end. Does nothing in a
  // blackout, with words on the screen, in a trial, or before the first frame.
  void KeepNow();

  // Waits until what was copied out is on the disk, or was refused.
  void Finish();

 private:
  class Writer;
  // What operators have set, and no more: the face breathes all the time.
  struct Called {
    std::array<std::uint16_t, 6> items{};
    std::array<show::Call, performance::kMostKept> toggles{};
    std::array<float, performance::kKnobCount> knobs{};
    friend bool operator==(const Called&, const Called&) = default;
  };
  // The part of a state that operators have set.
  static Called CalledOf(const performance::State& state);
  // Copies picture and state out and hands them to the writer; false where the writer is busy or there is no
  // picture.
  bool Keep();

  Look look_;
  IsOnTrial is_on_trial_;
  std::unique_ptr<Writer> writer_;
  // What the file holds, or will when the writer is done; nothing where that is not known.
  std::optional<Called> kept_;
  performance::State seen_;
  // The frame that was observed last is one to keep: no blackout, no caption.
  bool fit_ = false;
  // True until the first frame was observed.
  bool first_ = true;
  Time not_before_{};
  Time still_at_{};  // When no motion played, the last time.
};

}  // namespace kaori::stage
