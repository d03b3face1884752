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
  // Writes what stands on screen `head` as PNG. Errors: no_such_device (no such head, or no power),
  // timed_out.
  virtual Result<void> Shoot(int head, const std::string& file) = 0;
};

// What a stranger might plug in.
enum class Stranger { kStorage, kNetwork, kKeyboard };

// One at a time.
class StrangerProtocol {
 public:
  virtual ~StrangerProtocol() = default;
  // Errors: no_such_device (no power), invalid_argument (in the machine's own words).
  virtual Result<void> PlugStranger(Stranger stranger) = 0;
  virtual Result<void> PullStranger() = 0;
};

class WitnessProtocol {
 public:
  virtual ~WitnessProtocol() = default;
  // Asks the witness in the machine; see kaori-hil-agent. Errors: invalid_argument (what it said no with),
  // timed_out, no_such_device.
  virtual Result<std::string> Ask(const std::string& question, Duration longest) = 0;
};

}  // namespace kaori::hil
