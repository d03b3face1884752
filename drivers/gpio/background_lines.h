// GPIO lines on a thread of their own, so that a chip behind USB that is slow to answer keeps nobody waiting.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/gpio_lines.h"

namespace kaori::gpio {

// As ports::GpioLines, of lines whose calls may block: USB gives a chip 5 s for an answer, and other devices beside it are
// read meanwhile. Edges keep their order and their stamps. A level that differs from what the edges told is an edge, too: what
// the kernel lost is made up for. An output is driven soon after Drive returns; one that could not be driven is tried again with
// whatever comes next. One thread calls the members.
class BackgroundLines final : public ports::GpioLines {
 public:
  // A chip that answers nothing for so long, or only with faults, is gone, by no_such_device. It is noticed by a call: the descriptor
  // does not tell of it.
  static constexpr Duration kLongestAnswer = std::chrono::seconds(10);

  // Reads the levels before it returns, which may block. `lines` has so many outputs. `clock` outlives the lines. Errors: those of
  // GpioLines::Levels and of eventfd(2).
  static Result<std::unique_ptr<BackgroundLines>> Begin(std::unique_ptr<ports::GpioLines> lines,
                                                        std::size_t outputs, const Clock& clock);
  // Waits for the call that the thread makes just then.
  ~BackgroundLines() override;

  int pollable() const override { return told_.get(); }
  Result<std::uint32_t> Levels() override;
  Result<ports::GpioEdge> ReadEdge() override;
  Result<void> Drive(std::uint32_t line, bool active) override;

 private:
  BackgroundLines(std::unique_ptr<ports::GpioLines> lines, std::size_t outputs, const Clock& clock,
                  std::uint32_t levels, UniqueFd told, UniqueFd wake);

  // The thread's function, until the end or until the chip is gone.
  void Run();
  // Waits until there is something to do, but no longer than a moment after a fault; false at the end.
  bool Wait();
  // As Drive has asked since the last time.
  void DriveOutputs();
  // Gives on the edges that wait, and what the levels tell beside them.
  Result<void> ReadLines();
  // The chip has answered.
  void NoteAnswer();
  // Keeps it for ReadEdge, unless it changes nothing.
  void Give(const ports::GpioEdge& edge);
  // Keeps a fault for ReadEdge.
  void Report(const Error& error);
  // Whether the chip is gone, or has not answered for too long. Under the mutex.
  bool IsLost();

  // The thread's alone, but for their end.
  std::unique_ptr<ports::GpioLines> lines_;
  const Clock& clock_;
  // Readable while there is an edge or a fault to be given.
  UniqueFd told_;
  // Readable while the thread is wanted.
  UniqueFd wake_;
  // All below are shared with the thread, under the mutex.
  std::mutex mutex_;
  // That were read and not given, the oldest first.
  std::deque<ports::GpioEdge> edges_;
  std::uint32_t levels_;  // After all edges that were read,
  std::uint32_t given_;   // and after the last that was given.
  // The last one that was not given.
  std::optional<Error> fault_;
  // Why every call fails from now on.
  std::optional<Error> gone_;
  // What each output is still to be driven to.
  std::vector<std::optional<bool>> wanted_;
  Time asked_{};  // Since when the chip owes an answer that is no fault; zero while it owes none.
  bool is_ending_ = false;
  bool wants_levels_ = false;  // The thread's: they were not read since the last edge.
  std::thread thread_;         // Last: it uses all the others.
};

}  // namespace kaori::gpio
