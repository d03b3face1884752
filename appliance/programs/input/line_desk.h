// GPIO lines to the board: foot switches and service switches; and the tally lamp.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "appliance/core/board/board.h"
#include "drivers/base/clock.h"
#include "drivers/ports/gpio_lines.h"

namespace kaori::input {

// Contacts bounce: after a change a line keeps its state for so long, whatever its edges say.
inline constexpr Duration kBounce = std::chrono::milliseconds(12);

// One thread. Starts from what the section holds; a line that was active when a predecessor died and still is
// was not pushed again. Lines that are not there, or were lost, are opened anew every second.
class LineDesk {
 public:
  // `open` is empty where the box has no lines: the section stays as it is.
  LineDesk(const board::Board& board, board::Writer<board::Lines> writer, ports::GpioOpener open);

  // Takes every edge that waits; never blocks, but for what opening takes.
  void Step(Time now);

  // Output 0, where one is wired, from now on.
  void Light(bool tally);

  int pollable() const { return lines_ ? lines_->pollable() : -1; }
  std::uint32_t generation() const { return generation_; }  // Changes with pollable().

 private:
  void Open(Time now);
  void Begin(Time now);
  void HandleEdges(Time now);
  void LookAtLevels(Time now);
  void Settle(std::uint32_t line, Time at);
  void SettleAll(Time now);
  void Lose(const Error& error, Time now);
  void Write(Time at, board::SourceState source);

  board::Writer<board::Lines> writer_;
  ports::GpioOpener open_;
  std::unique_ptr<ports::GpioLines> lines_;
  board::Lines value_;
  board::SourceState source_;
  std::uint32_t told_ = 0;             // What the lines said last; the board follows when it has settled.
  std::array<Time, 32> changed_at_{};  // When each line last changed on the board.
  std::optional<bool> tally_;          // What the lamp was told; nothing since the lines came.
  Time retry_at_{};
  std::errc logged_{};  // Why they could not be opened: the same again is not logged.
  std::uint32_t generation_ = 0;
};

}  // namespace kaori::input
