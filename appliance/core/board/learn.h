// Learn mode: a person says what is to be played or called and moves a control; the box finds out which control
// that was, and keeps it when the person agrees.
#pragma once

#include <cstdint>
#include <string>

#include "appliance/core/board/line_check.h"

namespace kaori::board {

// Where a lesson stands. Each phase lasts until a person, a control or the disk ends it; a new lesson begins at kAsking
// from any of them.
enum class LearnPhase : std::uint32_t {
  kNever,    // Nobody has taught since the stage started.
  kAsking,   // A control is to be moved.
  kFound,    // One was: shall it be kept?
  kUnfit,    // One was, and it springs back to its middle, where the level has no rest.
  kKeeping,  // The file is being written.
  kKept,     // It is written, and the stage starts again with it.
  kRefused,  // It could not be written; the log says why.
  kEnded,    // By a person; what was kept before stays.
};
inline constexpr std::uint32_t kLearnPhaseCount = 8;

// What a call of CallVerb::kLearn asks for. The call's `value` of kBegin says which level it is for, as
// Learn::choice does. The last two are kaori-input's answers to a turn that is to be kept.
enum class LearnCall : std::uint32_t { kEnd, kBegin, kKeep, kTurnRound, kTurnKept, kTurnRefused };

//   writer   kaori-stage at each frame while somebody teaches, and once when it has ended
//   readers  kaori-input, which keeps what a turn has; kaori-shows, whose list waits meanwhile; kaori-stage, kaori-desk and
//            kaori-status for people; who shows it to people: in the demo its page
//   stale    never written so; a stage is taken for dead by the age of the stamp
struct Learn {
  static constexpr const char* kName = "learn";
  LearnPhase phase = LearnPhase::kNever;
  // What is taught, counted from 0: levels that every show has (show::Level), then the show's faces and its
  // expressions as levels; then what buttons may call (roles::TeachableCalls); last how many counts one turn of
  // a dial has.
  std::uint32_t choice = 0;
  CheckedItem found{};          // The control, from kFound on: an axis or a dial; of a call a button.
  std::uint32_t inverted = 0;   // 1: its lower end is the level's upper one.
  std::uint32_t instead = 0;    // 1: it plays something else until now.
  std::uint32_t restless = 0;   // 1: this control does not rest, so that it cannot be the one that is meant.
  CheckedItem moves_itself{};   // It; nothing while `restless` is 0.
  std::uint32_t ambiguous = 0;  // 1: two controls moved alike.
  // Of the lesson of a turn: counts on the board in that turn of the dial `found`, and from kKeeping on a number
  // that no lesson before had; 0: there is none to be kept.
  std::uint32_t turn_counts = 0;
  std::uint32_t turn_lesson = 0;
};

// The name of an axis, a dial or a button with its device, for people: "left stick twist", "dial box dial 3".
std::string NameOf(const CheckedItem& control);

}  // namespace kaori::board
