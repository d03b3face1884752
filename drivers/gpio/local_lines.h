// The simulator's switches and lamp as GPIO lines: edges over packets instead of a chip of the kernel.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/gpio_lines.h"

namespace kaori::gpio {

// As ports::GpioLines. The panel says with its first packet how many lines it has and which are active,
// and then tells each edge with its time; active-low wiring and bouncing contacts are its own business.
// The packets are those of firmware/wire/link_lines.h. One thread.
class LocalLines final : public ports::GpioLines {
 public:
  // Connects to "<folder>/lines.<port>" and returns at once; the lines can be used after Greet. Errors:
  // no_such_device (nobody listens there), permission_denied.
  static Result<std::unique_ptr<LocalLines>> Connect(const std::string& folder,
                                                     const std::string& port = "lines");

  // Waits for the panel's first packet, `patience` at most: the one call that
  // may block. Called once, before the others. Errors:
  //   timed_out       the panel said nothing
  //   no_such_device  it hung up
  //   io_error        the packet is none of the protocol
  Result<void> Greet(Duration patience);

  // Owns the connected socket. `name` is for errors.
  LocalLines(UniqueFd socket, std::string name) : socket_(std::move(socket)), name_(std::move(name)) {}

  int pollable() const override { return socket_.get(); }

  // The levels of the panel's first packet, and afterwards those after the last edge that ReadEdge gave.
  Result<std::uint32_t> Levels() override;

  // A packet that is none of the protocol gives io_error, now and from then on.
  // Edges keep the order and the stamps of the panel.
  Result<ports::GpioEdge> ReadEdge() override;
  Result<void> Drive(std::uint32_t line, bool active) override;

 private:
  tl::unexpected<Error> Broken();
  // Notes that the panel is gone, and that the protocol was broken; both are told by every later call.
  tl::unexpected<Error> Gone();

  // Readable when the panel tells an edge, or has gone.
  UniqueFd socket_;
  // For errors: the socket's path.
  std::string name_;
  std::uint32_t inputs_ = 0;  // How many there are; of both 32 at most.
  // Of both 32 at most: the bits of a level.
  std::uint32_t outputs_ = 0;
  std::uint32_t active_ = 0;  // Bit n: input line n.
  // The panel said what makes no sense: reading fails from then on.
  bool broken_ = false;
  bool gone_ = false;  // The panel was unplugged: every call says so.
};

// Connects, and waits for the panel for a tenth of a second at most. Errors: those of Connect and Greet.
Result<std::unique_ptr<ports::GpioLines>> OpenLocalLines(const std::string& folder);

}  // namespace kaori::gpio
