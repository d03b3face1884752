#include "firmware/surface/lamps.h"

namespace kaori::surface {

std::uint32_t Lamps::Tick() {
  const std::uint8_t tick = tick_;
  tick_ = static_cast<std::uint8_t>(tick + 1 == kBrightest ? 0 : tick + 1);
  const unsigned weight = tick < 8 ? 8U : tick < 12 ? 4U : tick < 14 ? 2U : 1U;
  return (brightness_ & weight) != 0 ? lit_ : 0;
}

}  // namespace kaori::surface
