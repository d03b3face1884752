// Learn mode as the stage runs it: a person picks a level and moves a control, or a call and pushes a button,
// and the box keeps which one; or turns a dial once around, and the box keeps how many counts that is.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/linecheck/button_finder.h"
#include "appliance/core/linecheck/control_finder.h"
#include "appliance/core/linecheck/turn_finder.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/roles/own_buttons.h"
#include "appliance/core/roles/taught.h"
#include "appliance/core/show/show.h"
#include "appliance/programs/stage/taught_writer.h"

namespace kaori::stage {

// It begins by a call or by the key End while the service key is on, and ends by a call, by End or Escape,
// when the service key is turned off, and when nobody has done anything for two minutes. Up and Down choose
// the level, Left and Right turn a control round that was found, Enter keeps it; calls do the same. What is
// kept is written at once and played when the stage has started again: over() asks for that when it has ended.
//
// Meanwhile the show gets nothing of what people move, and of calls on the board PANIC and BLACKOUT alone.
// Lips and voice play on. One thread.
class Learner {
 public:
  // Borrows the writer.
  explicit Learner(board::Writer<board::Learn>& writer) : writer_(writer) {}

  // The roles to be taught. Until then, and where they have no file, nothing is learnt. To be called before
  // the first Step.
  void SetRoles(OwnRoles own) {
    own_ = std::move(own);
    calls_ = roles::TeachableCalls(own_.items);
  }

  // Of one frame: what people do, and what the show gets, where an evening from the log plays some of them.
  struct Frame {
    const board::Snapshot& live;
    const board::Snapshot& snapshot;
    const show::Show& show;  // That is played.
    Time now{};
  };
  // Handles calls and keys, takes out of `events` what the show is not to have, and gives what is left of the
  // board for it; that holds until the next call. Writes how it stands on the board. Allocates only in a
  // frame in which something is begun, found or kept, and for the lines.
  const board::Snapshot& Step(const Frame& frame, performance::InputEvents& events);

  bool running() const { return running_; }
  // Lines for the picture while it runs.
  std::vector<std::string> Lines() const;

  // It has ended, and something was kept: the roles that are played from the next start on. Null before.
  const show::Roles* over() const { return !running_ && kept_ ? &*kept_ : nullptr; }

 private:
  struct Wish {
    std::optional<board::LearnCall> call;
    std::optional<board::LearnCall> answer{};  // Of kaori-input.
    std::optional<std::uint32_t> choice;       // Of kBegin.
    int step = 0;                              // To another level.
  };
  Wish ReadWish(performance::InputEvents& events) const;
  bool MayBegin(const Frame& frame) const;
  void Begin(const Frame& frame);
  void Choose(std::uint32_t choice, const Frame& frame);
  void Do(const Wish& wish, const Frame& frame);
  // Looks whether another control was found, and whether what is kept is written.
  void Look(const Frame& frame);
  // The same of a turn of a dial, and of kaori-input's answer to it.
  void LookAtTurns(const Frame& frame);
  void AwaitTurnKept(const Frame& frame);
  // What is found, as a lesson; says whether it fits.
  void Propose(const Frame& frame);
  void ProposeControl(const Frame& frame);
  void ProposeButton(const Frame& frame);
  void Keep(const Frame& frame);
  void EndWhereDue(const Frame& frame);
  void End(const char* why);
  void Withhold();

  std::uint32_t ChoiceCount() const;
  // Whether it is something to be called, by a button, and no level.
  bool IsCall() const;
  // Whether it is how many counts one turn of a dial has, which is no lesson of roles.
  bool IsTurn() const;
  std::vector<std::string> LinesOfTurn() const;
  std::string NameOfChoice() const;
  bool IsFound() const {
    return now_.phase == board::LearnPhase::kFound || now_.phase == board::LearnPhase::kRefused;
  }

  board::Writer<board::Learn>& writer_;
  OwnRoles own_;
  std::vector<std::string> calls_;       // That a button may be taught.
  bool running_ = false, ends_ = false;  // ends_: somebody wants it to end.
  board::Learn now_;
  linecheck::ControlFinder controls_;
  linecheck::ButtonFinder buttons_;
  linecheck::TurnFinder turns_;
  std::optional<board::LearnCall> answer_;  // Of kaori-input, to the turn that is to be kept.
  std::optional<board::CheckedItem> found_;
  std::optional<Lesson> lesson_;      // That would be kept.
  std::vector<std::string> instead_;  // What the control moves or calls until now.
  std::optional<TaughtWriter> file_;
  std::optional<show::Roles> kept_;
  Time changed_at_{};
  std::array<float, 2> sliders_{};  // Of both sticks, when it began: where the show has them meanwhile.
  board::Snapshot left_;
};

}  // namespace kaori::stage
