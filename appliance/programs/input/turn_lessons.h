// Takes from the stage what one turn of a dial had on the board, and keeps it for the device that was turned.
#pragma once

#include <cstdint>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/dial_slot.h"
#include "appliance/programs/input/learnt_turns.h"
#include "appliance/programs/input/line_inputs.h"
#include "drivers/base/clock.h"

namespace kaori::input {

// Learn mode is the stage's, which knows no device; here is known which device moved a dial. One thread.
class TurnLessons {
 public:
  // Borrows all of them. A lesson that stands on the board already is nobody's any more.
  TurnLessons(const board::Board& board, LearntTurns& turns, LineInputs& lines);

  void Add(DialSlot& slot) { slots_.push_back(&slot); }
  // To be called at each step of the service. A new lesson is kept and answered by a call; it blocks for the disk
  // then, in service, while nothing plays.
  void Step(Time now);

 private:
  // The device that turned that dial of the board last; null: none that is plugged in did.
  DialSlot* LastAt(std::size_t dial) const;
  Result<void> Accept(const board::Learn& learn);

  const board::Board& board_;
  LearntTurns& turns_;
  LineInputs& lines_;
  std::vector<DialSlot*> slots_;
  std::uint32_t seen_;
};

}  // namespace kaori::input
