// A seat at the desk: one role that one HID device may take, and its section of the board.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::input {

// How long what a dead predecessor left as held is believed without a report that says so. A device that is
// held tells so at once when it is opened; one at rest tells nothing.
inline constexpr Duration kProof = std::chrono::milliseconds(250);

// One thread. Starts from what its section holds, so that a restart changes nothing.
class Seat {
 public:
  virtual ~Seat() = default;

  // For the log: "dial box", "left stick".
  virtual std::string_view name() const = 0;

  // A device sits down. Errors: as the decoder's For; the seat stays empty then.
  virtual Result<void> Plug(const ports::HidIdentity& identity, Time now) = 0;

  // Takes one input report. Errors: bad_message  torn, short, long or unknown; nothing changed.
  virtual Result<void> Accept(std::span<const std::uint8_t> report, Time at) = 0;

  // Writes the section if a report was taken since the last call: once for all that waited.
  virtual void Publish() = 0;

  // The device is gone, or was not there when the program came back: buttons go up, what accumulates holds.
  virtual void Unplug(Time now) = 0;

  // What happens by itself. `device` is what sits here; null while nothing does.
  virtual void Tick(Time now, ports::HidChannel* device) = 0;
};

}  // namespace kaori::input
