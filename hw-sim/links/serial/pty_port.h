// A serial box at the other end of a pseudo-terminal, where a driver of the product finds it as a serial
// line.
#pragma once

#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "hw-sim/devices/serial_dial_box.h"

namespace kaori::sim {

// A pseudo-terminal keeps the line's settings: where the driver set another speed than the box has, bytes
// arrive spoilt. A kernel passes bytes on by itself, some microseconds after they were written. One thread;
// nothing blocks.
class PtyPort {
 public:
  // `path` is where the driver looks, such as a name in a folder of its own. Borrows the box. Unplugged at
  // first.
  PtyPort(std::string path, SerialDialBox& box) : path_(std::move(path)), box_(box) {}
  PtyPort(const PtyPort&) = delete;
  PtyPort& operator=(const PtyPort&) = delete;
  ~PtyPort() { Unplug(); }

  // Errors: those of posix_openpt(3) and symlink(2).
  Result<void> Plug();
  // The adapter is pulled: the line hangs up, its name is gone, the box is without power.
  void Unplug();

  // Carries bytes both ways as far as they have come at `now`. Returns how many left the box.
  std::size_t Pump(Time now);
  // Any bytes, at once.
  void SendRaw(std::span<const std::uint8_t> bytes);

 private:
  bool has_its_speed() const;

  std::string path_;
  SerialDialBox& box_;
  UniqueFd box_end_;
  UniqueFd line_;  // Kept open, or the other end would hang up whenever no driver has it.
};

}  // namespace kaori::sim
