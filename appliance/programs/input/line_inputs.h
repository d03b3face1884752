// GPIO lines: switches go to the board, those for GO, BACK and PANIC as calls, and the tally lamp is driven.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "appliance/core/board/caller.h"
#include "drivers/base/clock.h"
#include "drivers/ports/gpio_lines.h"

namespace kaori::input {

// Contacts bounce: after a change a line keeps its state for this long, whatever its edges say. Switches of
// this kind bounce for 1 to 10 ms, and nobody treads twice within it.
inline constexpr Duration kBounce = std::chrono::milliseconds(12);

// Used by one thread. It starts from what the section holds: a line that was active before a restart and
// still is counts as one push, and one for GO, BACK or PANIC calls it then. Lines that are absent or were lost are opened
// again every second, or seldom where that takes long: a chip that does not answer costs a twentieth of the time.
class LineInputs {
 public:
  // `open` is empty where the box has no lines; the section then stays as it is. The board is not kept, and the
  // clock is borrowed. `wired` is as Lines has it.
  // `open` may be called any number of times, from Step alone.
  LineInputs(const board::Board& board, board::Writer<board::Lines> writer, board::Caller caller,
             ports::GpioOpener open, const Clock& clock, std::uint32_t wired = board::kEveryLine);

  // Handles the edges that wait, 256 at most. It never blocks, apart from the time that opening the chip
  // needs.
  void Step(Time now);

  // Makes a call in this program's name: whoever else here has one makes it by the one writer of them.
  void Call(const board::Call& call) { caller_.Make(call); }

  // Switches the tally lamp, output 0, where one is wired; one that cannot be switched just now is switched
  // by a later call. A lamp that fails otherwise is ignored.
  void SetTally(bool lit);

  // The descriptor that is readable when an edge waits; -1 while no lines are open.
  int pollable() const { return lines_ ? lines_->pollable() : -1; }
  std::uint32_t generation() const { return generation_; }  // Changes whenever pollable() may.

 private:
  // Tries to open the lines; on success begins with them as they stand.
  void Open(Time now);
  // Makes the section live.
  void Begin(std::uint32_t levels, Time now);
  // Settles the edges that wait, each at the kernel's time of it.
  void HandleEdges(Time now);
  // Asks for all levels, since the kernel may have dropped edges.
  void ReadLevels(Time now);
  // Brings one line of the board up to its level, unless it changed within the bounce.
  void Settle(std::uint32_t line, Time at);
  void SettleAll(Time now);
  // A transfer failed: it is passed over, unless the chip is gone or many failed in a row.
  void HandleFault(const Error& error, Time now);
  // The chip is gone: all lines are released, and it is opened again later.
  void HandleLoss(const Error& error, Time now);
  // All lines of the board are let go, and the section is stale.
  void Release(Time now);
  void Write(Time at, board::SourceState source);

  board::Writer<board::Lines> writer_;
  board::Caller caller_;
  // How the lines are opened; empty where the box has none.
  ports::GpioOpener open_;
  // That of the times which Step is given: asked again after a call that may have taken long.
  const Clock& clock_;
  std::unique_ptr<ports::GpioLines> lines_;
  // The section as it was published last.
  board::Lines value_;
  board::SourceState source_;
  std::uint32_t levels_ = 0;  // As last reported, bit n for line n; the board follows once a line settled.
  std::array<Time, 32> changed_at_{};  // When each line last changed on the board.
  std::optional<bool> shown_tally_;    // As the lamp was last switched; empty after the lines were opened.
  bool has_edges_ = false;             // Since all levels were read.
  // Failed transfers in a row, and when the last of them was.
  int faults_ = 0;
  Time fault_at_{};
  Time retry_at_{};
  std::errc logged_{};  // Why opening failed last: the same cause is not logged again.
  std::uint32_t generation_ = 0;
};

}  // namespace kaori::input
