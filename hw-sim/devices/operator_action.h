// One movement of an operator's hand, or of a cable, as a plain value: what scenarios are made of.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "drivers/base/clock.h"

namespace kaori::sim {

// Where a simulated device is plugged in; the names are the ports of the link.
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
inline constexpr int kDevicePortCount = 10;

// "dial-box", "stick-left", "stick-right", "keyboard", "camera", "screen", "pointer", "microphone",
// "loudspeaker".
std::string_view PortName(DevicePort port);
std::optional<DevicePort> DevicePortNamed(std::string_view port);

enum class Verb : std::uint8_t {
  kTurn,       // Dial `index` by `a` turns, clockwise is positive.
  kPush,       // Button or key `index` goes down,
  kRelease,    // and up.
  kMove,       // Stick or pointer to x = `a`, y = `b`.
  kTwist,      // Stick's twist to `a`.
  kSlide,      // Stick's slider to `a`.
  kHat,        // Stick's hat to `index`, -1 is centred.
  kRoll,       // Pointer's wheel by `a` notches, away from the hand is positive.
  kLips,       // Mouth to height `a`, width `b`.
  kCoverLens,  // `index` 1 covers, 0 uncovers.
  kStall,      // Camera, microphone or loudspeaker stops (`index` 1) or goes on (0).
  kVoice,      // The voice says vowel `index` (0 to 4: a, i, u, e, o), `a` loud: 0 silent, 1 as one speaks.
  kPlug,
  kUnplug,
};

struct OperatorAction {
  DevicePort port = DevicePort::kDialBox;
  Verb verb = Verb::kTurn;
  int index = 0;
  double a = 0;
  double b = 0;
  friend bool operator==(const OperatorAction&, const OperatorAction&) = default;
};

// What all simulated devices share: the time, and someone who watches the hands.
struct DeviceContext {
  const Clock& clock;
  std::function<void(const OperatorAction&)>
      watcher;  // May be empty. Called for every hand that changes something.

  void Notify(const OperatorAction& action) const {
    if (watcher) watcher(action);
  }
};

}  // namespace kaori::sim
