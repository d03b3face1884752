#include "hw-sim/devices/operator_action.h"

#include <array>

namespace kaori::sim {
namespace {

// In the order of DevicePort.
constexpr std::array<std::string_view, kDevicePortCount> kPortNames{
    "dial-box", "stick-left", "stick-right", "keyboard",    "camera",
    "screen",   "pointer",    "microphone",  "loudspeaker", "lines"};

}  // namespace

// Both directions use one table, so that a name is read back as the port that it was written for.
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
