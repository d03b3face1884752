#include "hw-sim/devices/operator_action.h"

#include <array>

namespace kaori::sim {
namespace {

// In the order of DevicePort.
constexpr std::array<std::string_view, kDevicePortCount> kPortNames{
    "dial-box", "stick-left", "stick-right", "keyboard",    "camera",
    "screen",   "pointer",    "microphone",  "loudspeaker", "lines"};

}  // namespace

std::string_view PortName(DevicePort port) {
  return kPortNames[static_cast<std::size_t>(port)];
}

std::optional<DevicePort> DevicePortNamed(std::string_view port) {
  for (std::size_t n = 0; n < kPortNames.size(); ++n) {
    if (kPortNames[n] == port) return static_cast<DevicePort>(n);
  }
  return std::nullopt;
}

}  // namespace kaori::sim
