// What a bench can do with a box, whatever the box is: a virtual machine, or a real one with other drivers
// behind these.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::hil {

// The plug of a box.
class PowerProtocol {
 public:
  virtual ~PowerProtocol() = default;
  // Gives the box power and returns; whether it starts is for others to see.
  // Errors: those of the implementation.
  virtual Result<void> On() = 0;
  // As if the plug were pulled.
  virtual void Off() = 0;
};

// What a box shows.
class VideoProtocol {
 public:
  virtual ~VideoProtocol() = default;
  // Writes the picture of screen `head` as PNG into `file`, an absolute path. Blocks until it is
  // written. Errors: no_such_device (no such head, or no power), timed_out.
  virtual Result<void> Shoot(int head, const std::string& file) = 0;
  // Plugs a screen of that size into output `head`, instead of the one before; 0 by 0: unplugs it. Errors:
  // no_such_device (no such output, or no power).
  virtual Result<void> PlugScreen(int head, int width_px, int height_px) = 0;
};

// USB devices that no profile, or not every profile, authorises.
enum class UnauthorisedDevice { kStorage, kNetwork, kKeyboard };

// What is wrong with a stick.
struct StickFault {
  // No read of this byte of its disk comes back, as where its memory is worn out.
  std::optional<std::uint64_t> unreadable_at;
  // It gives no more in a second; 0: all that is asked for.
  std::int64_t most_bytes_s = 0;
};

// A USB socket of the box for such a device. One at a time.
class UnauthorisedDeviceProtocol {
 public:
  virtual ~UnauthorisedDeviceProtocol() = default;
  // Success means that the device is on the bus, not that the box uses it. Errors: no_such_device (no
  // power), invalid_argument (QEMU's own message).
  virtual Result<void> PlugUnauthorised(UnauthorisedDevice device) = 0;
  // Plugs in a USB stick with that image of a disk, an absolute path; unless it is writable it is only read.
  // Errors: as above.
  virtual Result<void> PlugStick(const std::string& image, bool writable) = 0;
  // The same with one that fails, and is only read.
  virtual Result<void> PlugFailingStick(const std::string& image, const StickFault& fault) = 0;
  // Pulls what was plugged in. Errors: as above; where there is none QEMU says so (invalid_argument).
  virtual Result<void> PullUnauthorised() = 0;
};

// The program on the box's side that answers the bench (tests/hil); the image as it ships has none.
class AgentProtocol {
 public:
  virtual ~AgentProtocol() = default;
  // Asks the agent in the guest; see kaori-hil-agent for its questions. Blocks until it answers,
  // `longest` at most; simulated devices play on meanwhile. An answer that comes later is lost. Errors:
  // invalid_argument (its own error message), timed_out, no_such_device.
  virtual Result<std::string> Ask(const std::string& question, Duration longest) = 0;
};

}  // namespace kaori::hil
