#include "firmware/surface/lamps.h"

namespace kaori::surface {

// Binary code modulation: tick 0 to 7 shows bit 3 of the brightness, 8 to 11 bit 2, 12 and 13 bit 1, 14 bit
// 0.
std::uint32_t Lamps::Tick() {
  const std::uint8_t tick = tick_;
  tick_ = static_cast<std::uint8_t>(tick + 1 == kBrightest ? 0 : tick + 1);
  const unsigned weight = tick < 8 ? 8U : tick < 12 ? 4U : tick < 14 ? 2U : 1U;
  return (brightness_ & weight) != 0 ? lit_ : 0;
}

}  // namespace kaori::surface
