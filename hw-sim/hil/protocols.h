// What a bench can do with a box, whatever the box is: a virtual machine, or a real one with other drivers
// behind these.
#pragma once

#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::hil {

class PowerProtocol {
 public:
  virtual ~PowerProtocol() = default;
  virtual Result<void> On() = 0;
  virtual void Off() = 0;  // As if the plug were pulled.
};

class VideoProtocol {
 public:
  virtual ~VideoProtocol() = default;
  // Writes the picture of screen `head` as PNG. Errors: no_such_device (no such head, or no power),
  // timed_out.
  virtual Result<void> Shoot(int head, const std::string& file) = 0;
};

// USB devices that no profile, or not every profile, authorises.
enum class UnauthorisedDevice { kStorage, kNetwork, kKeyboard };

// One at a time.
class UnauthorisedDeviceProtocol {
 public:
  virtual ~UnauthorisedDeviceProtocol() = default;
  // Errors: no_such_device (no power), invalid_argument (QEMU's own message).
  virtual Result<void> PlugUnauthorised(UnauthorisedDevice device) = 0;
  virtual Result<void> PullUnauthorised() = 0;
};

class AgentProtocol {
 public:
  virtual ~AgentProtocol() = default;
  // Asks the agent in the guest; see kaori-hil-agent. Errors: invalid_argument (its own error message),
  // timed_out, no_such_device.
  virtual Result<std::string> Ask(const std::string& question, Duration longest) = 0;
};

}  // namespace kaori::hil
