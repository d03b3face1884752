// A dial box on a serial line, as the HID device that our own dial box is.
#pragma once

#include <array>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/decode/dial_box_reporter.h"
#include "drivers/decode/serial_dials.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::serial {

// A line, and who speaks on it.
struct SpokenLine {
  UniqueFd line;
  decode::SerialDialSession session;
};

// Sends what the session has to say. What the line does not take whole is lost: a line of 9600 baud takes
// four thousand bytes.
void SendDue(SpokenLine& spoken, Time now);

// What a channel leaves behind for its bus.
struct SerialLoan {
  bool is_out = false;       // The channel lives.
  bool was_strange = false;  // The last one ended since what came was no message of its kind of box.
};

// As ports::HidChannel: each message of the box that changes something becomes a report of
// firmware/wire/dial_box.h, and lamps go back as that report says them. Read also says
//   no_such_device  too: what comes is no message of this kind of box
//   bad_message     a torn message was passed over, and the line stays open
// One thread.
class SerialChannel final : public ports::HidChannel {
 public:
  // `port` names it. Borrows the clock and the loan, which outlive it.
  SerialChannel(SpokenLine spoken, std::string port, const Clock& clock, SerialLoan& loan);
  ~SerialChannel() override { loan_.is_out = false; }

  int pollable() const override { return spoken_.line.get(); }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t> into) override;
  Result<void> Write(std::span<const std::uint8_t> report) override;

 private:
  // Reads what the line has where all bytes before were decoded. Errors: as Read.
  Result<void> Fill();
  ports::HidInput Report(std::span<std::uint8_t> into);

  SpokenLine spoken_;
  ports::HidIdentity identity_;
  const Clock& clock_;
  SerialLoan& loan_;
  std::array<std::uint8_t, 256> bytes_{};  // As they came, of which those before next_ were decoded.
  std::size_t next_ = 0;
  std::size_t end_ = 0;
  Time read_at_{};
  decode::DialBoxReporter reporter_;
  std::uint32_t told_torn_;
};

}  // namespace kaori::serial
