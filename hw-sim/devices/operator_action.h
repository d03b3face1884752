// One action of an operator on a device, or on its cable, as a plain value: scenarios are made of these, and
// so is what a page sends and what a recording keeps.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "drivers/base/clock.h"

namespace kaori::sim {

// Where a simulated device is plugged in. The order is that of kPortNames; new ones go to the end.
enum class DevicePort : std::uint8_t {
  kDialBox,
  kStickLeft,
  kStickRight,
  kKeyboard,
  kCamera,
  kScreen,
  kPointer,
  kMicrophone,
  kLoudspeaker,
  kLines
};
// How many ports there are.
inline constexpr int kDevicePortCount = 10;

// "dial-box", "stick-left", "stick-right", "keyboard", "camera", "screen", "pointer", "microphone",
// "loudspeaker", "lines". They are the ports of the local link, and the words of a scenario's
// cables. The view lives as long as the program.
std::string_view PortName(DevicePort port);
// Nothing where no port has that name.
std::optional<DevicePort> DevicePortNamed(std::string_view port);

// What is done. A device ignores the verbs that it does not have; kPlug and kUnplug are for its cable.
enum class Verb : std::uint8_t {
  kTurn,       // Dial `index` by `a` turns, clockwise is positive.
  kPush,       // Button or key `index` goes down, line `index` is switched on,
  kRelease,    // and up, and off.
  kMove,       // Stick or pointer to x = `a`, y = `b`.
  kTwist,      // Stick's twist to `a`.
  kSlide,      // Stick's slider to `a`.
  kHat,        // Stick's hat to `index`, -1 is centred.
  kRoll,       // Pointer's wheel by `a` notches, away from the operator is positive.
  kLips,       // Mouth to height `a`, width `b`.
  kCoverLens,  // `index` 1 covers, 0 uncovers.
  kStall,      // Camera, microphone or loudspeaker stops (`index` 1) or goes on (0).
  kVoice,      // The voice says vowel `index` (0 to 4: a, i, u, e, o), `a` loud: 0 silent, 1 as one speaks.
  // The port's cable; no device sees these.
  kPlug,
  kUnplug,
};

// Indices begin with 0, keys are usages of HID page 7. Values are those of the verb; what a verb does
// not use is 0, so that equal actions are equal values.
struct OperatorAction {
  // Whose control it is.
  DevicePort port = DevicePort::kDialBox;
  Verb verb = Verb::kTurn;
  // Which dial, button, key, line or vowel; of some verbs a switch, 0 or 1.
  int index = 0;
  // The verb's numbers, in the units and ranges of the device's own call.
  double a = 0;
  double b = 0;
  friend bool operator==(const OperatorAction&, const OperatorAction&) = default;
};

// What all simulated devices share: the time, and who is told of each action. One
// thread; it outlives the devices.
struct DeviceContext {
  // The one clock of the simulation.
  const Clock& clock;
  // May be empty. Called after every action that changed something, by whatever way
  // it came; it must not act itself.
  std::function<void(const OperatorAction&)> watcher;

  // Tells the watcher, if there is one.
  void Notify(const OperatorAction& action) const {
    if (watcher) watcher(action);
  }
};

}  // namespace kaori::sim
