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
// the kernel lost is made up for, and no edge is given that changes nothing. An output is driven soon after Drive returns; one
// that cannot be driven stays as it is. One thread calls the members.
class BackgroundLines final : public ports::GpioLines {
 public:
  // A chip that has not answered for so long is gone, by no_such_device.
  static constexpr Duration kLongestAnswer = std::chrono::seconds(10);

  // Reads the levels before it returns, which may block. `lines` has so many outputs. `clock` outlives the lines. Errors: those of
  // GpioLines::Levels and of eventfd(2).
  static Result<std::unique_ptr<BackgroundLines>> Begin(std::unique_ptr<ports::GpioLines> lines,
                                                        std::size_t outputs, const Clock& clock);
  // Waits for the call that the thread makes just then.
  ~BackgroundLines() override;

  int pollable() const override { return told_.get(); }
  // After all edges that were read, also of those that ReadEdge has still to give.
  Result<std::uint32_t> Levels() override;
  Result<ports::GpioEdge> ReadEdge() override;
  Result<void> Drive(std::uint32_t line, bool active) override;

 private:
  BackgroundLines(std::unique_ptr<ports::GpioLines> lines, std::size_t outputs, const Clock& clock,
                  std::uint32_t levels, UniqueFd told, UniqueFd wake);

  // The thread's function, until the end or until the chip is gone.
  void Run();
  // Waits until there is something to do; false at the end.
  bool Wait();
  void DriveOutputs();
  // Gives on the edges that wait, and what the levels tell beside them.
  Result<void> ReadLines();
  void Give(const ports::GpioEdge& edge);
  void Report(const Error& error);
  // Whether the chip is gone, or has not answered for too long. Under the mutex.
  bool IsLost();

  std::unique_ptr<ports::GpioLines> lines_;
  const Clock& clock_;
  UniqueFd told_;  // Readable while there is an edge or a fault to be given.
  UniqueFd wake_;  // Readable while the thread is wanted.
  // All below are shared with the thread, under the mutex.
  std::mutex mutex_;
  std::deque<ports::GpioEdge> edges_;
  std::uint32_t levels_;
  std::optional<Error> fault_;  // The last one that was not given.
  std::optional<Error> gone_;
  std::vector<std::optional<bool>> wanted_;  // What each output is still to be driven to.
  Time asked_{};  // Since when the thread waits for the chip; zero while it does not.
  bool is_ending_ = false;
  std::thread thread_;  // Last: it uses all the others.
};

}  // namespace kaori::gpio
