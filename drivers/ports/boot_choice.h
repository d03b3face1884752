// Which of the disk's two systems the machine starts.
#pragma once

#include <cstdint>

#include "drivers/base/result.h"

namespace kaori::ports {

// The two systems of a disk.
enum class Slot : std::uint8_t { kA, kB };

// The slot beside this one.
constexpr Slot Other(Slot slot) {
  return slot == Slot::kA ? Slot::kB : Slot::kA;
}

// The loader's choice. At each moment, and after a power cut in each call, the machine starts its default or,
// once, the one that is to be tried. One thread. Calls block for the disk and the firmware.
class BootChoice {
 public:
  virtual ~BootChoice() = default;

  // The slot that starts by itself. Errors: bad_message (what the loader reads is not what an image has
  // there), those of the disk.
  virtual Result<Slot> Default() = 0;

  // The slot from which this system was started. It is tried where it is not the default.
  virtual Slot running() const = 0;

  // Has the next start take this slot, and each one after that the default again. A second call replaces the
  // first. Errors:
  //   not_supported      this machine keeps nothing of it: its firmware has no variables, or forgets them
  //   permission_denied  this program may not
  virtual Result<void> TryOnce(Slot slot) = 0;

  // Makes a slot the default, and returns once that is on the disk and was read back. Nothing is written
  // where it is the default already. Errors: as Default, and those of BlockDevice.
  virtual Result<void> Confirm(Slot slot) = 0;
};

// Whether this system was started to be tried. Errors: those of Default.
inline Result<bool> IsTrial(BootChoice& choice) {
  return choice.Default().map([&](Slot by_itself) { return by_itself != choice.running(); });
}

}  // namespace kaori::ports
