#include "appliance/programs/input/turn_lessons.h"

#include <cmath>

#include "appliance/programs/input/settings.h"
#include "drivers/base/log.h"

namespace kaori::input {

// A program that was started anew in the middle of a lesson does not know who turned: the stage hears no answer, and says so.
TurnLessons::TurnLessons(const board::Board& board, LearntTurns& turns, LineInputs& lines)
    : board_(board), turns_(turns), lines_(lines), seen_(board.Read<board::Learn>().value.turn_lesson) {}

// A lesson has a number of its own, by which a new one is told from one that still stands on the board. A number of 0 says that
// there is none.
void TurnLessons::Step(Time now) {
  const board::Learn learn = board_.Read<board::Learn>().value;
  if (learn.turn_lesson == seen_) return;
  seen_ = learn.turn_lesson;
  if (learn.turn_lesson == 0 || learn.phase != board::LearnPhase::kKeeping) return;
  const auto accepted = Accept(learn);
  if (!accepted) LogWarning("what one turn has is not kept: {}", accepted.error().message());
  const auto answer = accepted ? board::LearnCall::kTurnKept : board::LearnCall::kTurnRefused;
  lines_.Call({.at = now, .verb = board::CallVerb::kLearn, .subject = static_cast<std::uint32_t>(answer)});
}

// Several devices may turn one dial of the board; a person turns one of them, and it was the last.
DialSlot* TurnLessons::LastAt(std::size_t dial) const {
  DialSlot* last = nullptr;
  for (DialSlot* slot : slots_)
    if (slot->turned_at(dial) != Time{} && (last == nullptr || slot->turned_at(dial) > last->turned_at(dial)))
      last = slot;
  return last;
}

// The board's counts are the device's own where nothing is known of it, and else in proportion.
Result<void> TurnLessons::Accept(const board::Learn& learn) {
  DialSlot* const slot = LastAt(learn.found.number);
  if (slot == nullptr) return FailInput("no device that is plugged in has turned that dial");
  const double own = std::round(slot->CountsOfItsOwn(learn.turn_counts));
  if (!(own >= 1 && own <= kMostCountsOfATurn)) return FailInput("the dial has no such encoder");
  const int counts = UsualCounts(static_cast<int>(own));
  if (auto kept = turns_.Keep(slot->identity(), counts); !kept) return kept;
  slot->SetCountsPerTurn(counts);
  Log("{} went {:.0f} counts in one turn, and is taken to have {}", slot->identity().name, own, counts);
  return {};
}

}  // namespace kaori::input
