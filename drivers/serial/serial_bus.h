// The serial lines on which a dial box of 1993 may be, as a bus of HID devices.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/serial/serial_channel.h"

namespace kaori::serial {

// A line is named by a person, since nothing tells what is at its other end: a box that is asked wrongly does
// not answer, but another device may do what nobody wants.
struct SerialBoxOptions {
  std::string path;  // Best of /dev/serial/by-path, which is the socket and not the adapter.
  decode::SerialBox box = decode::SerialBox::kSgi;
  int counts_per_turn = 256;
  Duration look_every =
      std::chrono::milliseconds(250);  // How often the line is looked for, while no channel has it.
};

// Reads "/dev/serial/by-path/...=sgi". Errors: invalid_argument, which names the kinds that there are.
Result<SerialBoxOptions> ParseSerialBox(const std::string& text, int counts_per_turn);

// As ports::HidBus, of one line, whose port is the last part of its path. It is looked for now and then, so
// that adapters may come and go. A port is listed once its box has answered; one that does not answer for a
// second is listed too, and Open then says why it cannot be had. Open also says
//   timed_out       nobody answers
//   protocol_error  what comes is no message of this kind of box
class SerialBus final : public ports::HidBus {
 public:
  // Opens no line yet. Borrows the clock. Errors: those of timerfd_create(2).
  static Result<std::unique_ptr<SerialBus>> Open(SerialBoxOptions options, const Clock& clock);

  int pollable() const override { return timer_.get(); }
  Result<std::vector<std::string>> Ports() override;
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string& port) override;

 private:
  SerialBus(SerialBoxOptions options, const Clock& clock, UniqueFd timer);
  // Opens the line, asks, and reads what was answered, as far as that is possible now.
  void Tend();
  // Why there is no channel to be had; nothing while there is, or while the box has time to answer.
  std::optional<Error> fault() const;
  bool is_ready() const;

  SerialBoxOptions options_;
  std::string port_;
  const Clock& clock_;
  UniqueFd timer_;  // Readable when the line is to be looked for.
  SerialLoan loan_;
  std::optional<SpokenLine> spoken_;  // Until a channel has it.
  std::optional<Error> refused_;      // Why the line could not be opened.
};

}  // namespace kaori::serial
