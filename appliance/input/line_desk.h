// GPIO lines to the board: foot switches and service switches.
#pragma once

#include "appliance/board/board.h"
#include "drivers/base/clock.h"
#include "drivers/ports/gpio_lines.h"

namespace kaori::input {

// One thread. Starts from what the section holds; a line that was active when a predecessor died and still is
// was not pushed again.
class LineDesk {
 public:
  // Borrows lines; null where the box has none: the section stays as it is.
  LineDesk(const board::Board& board, board::Writer<board::Lines> writer, ports::GpioLines* lines);

  // Takes every edge that waits; never blocks.
  void Step(Time now);

  int pollable() const { return lines_ == nullptr ? -1 : lines_->pollable(); }

 private:
  void Begin(Time now);
  void TakeEdge(const ports::GpioEdge& edge);
  void Lose(const Error& error, Time now);
  void Write(Time at, board::SourceState source);

  board::Writer<board::Lines> writer_;
  ports::GpioLines* lines_;
  board::Lines value_;
  bool begun_ = false;
};

}  // namespace kaori::input
