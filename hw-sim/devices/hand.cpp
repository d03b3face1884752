#include "hw-sim/devices/hand.h"

#include <array>

namespace kaori::sim {
namespace {

constexpr std::array<std::string_view, kPlaceCount> kPortNames{"dial-box", "stick-left", "stick-right",
                                                               "keyboard", "camera",     "screen",
                                                               "pointer",  "microphone", "loudspeaker"};

}  // namespace

std::string_view PortName(Place place) {
  return kPortNames[static_cast<std::size_t>(place)];
}

std::optional<Place> PlaceNamed(std::string_view port) {
  for (std::size_t n = 0; n < kPortNames.size(); ++n) {
    if (kPortNames[n] == port) return static_cast<Place>(n);
  }
  return std::nullopt;
}

}  // namespace kaori::sim
