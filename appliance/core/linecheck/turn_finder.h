// How many counts one turn of a dial has: learn mode asks a person to turn one once around.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "appliance/core/board/line_check.h"
#include "appliance/core/board/snapshot.h"
#include "drivers/base/clock.h"

namespace kaori::linecheck {

// A turn begins where all dials stand and ends when they have stood for 1.5 s again, which is longer than a hand
// takes to grip anew. What the dial went in between is its turn, whichever way; back and forth it is the
// difference. The search goes on: each further turn takes the place of the one before. One thread; time is an
// argument and does not go back. Allocates nothing.
class TurnFinder {
 public:
  struct Turn {
    board::CheckedItem dial;
    std::uint32_t counts = 0;  // Of the board.
  };

  // Begins anew: nothing is found.
  void Begin(const board::Snapshot& board, Time now);
  // To be called once a frame.
  void Look(const board::Snapshot& board, Time now);

  const std::optional<Turn>& found() const { return found_; }
  // Another dial went along by more than a tenth, and none was found; until the next is.
  bool ambiguous() const { return ambiguous_; }
  // When a dial moved, or a turn ended, last.
  Time changed_at() const { return changed_at_; }

 private:
  using Counts = std::array<std::int32_t, 8>;
  // At the end of a turn: whose it was, or that nobody can tell.
  void Decide();

  Counts from_{};  // Where the dials stood before the turn, and where they stood last.
  Counts last_{};
  std::optional<Turn> found_;
  bool ambiguous_ = false;
  Time changed_at_{};
};

}  // namespace kaori::linecheck
