// Which stepping of the RP2040 a chip is, and whether a surface may be built on it. Without registers, so that the
// tests have it as well.
#pragma once

#include <cstdint>

#include "firmware/wire/surface_feature.h"

namespace kaori::rp2040 {

// `chip_id` is the register of that name (2.20.2): bits 31 to 28 are 1 of B0 and B1, and 2 from B2 on. The two are
// told apart by the version of their ROM (2.8.3, address 0x13): 1 of B0, 2 of B1.
constexpr wire::ChipStepping SteppingOf(std::uint32_t chip_id, std::uint8_t rom_version) {
  if (chip_id >> 28 >= 2) return wire::ChipStepping::kB2;
  return rom_version <= 1 ? wire::ChipStepping::kB0 : wire::ChipStepping::kB1;
}

// RP2040-E5: before B2 the device may never connect on a hub that is busy. The way around it takes GPIO 15, which
// is line B of dial 8 here.
constexpr bool IsFit(wire::ChipStepping stepping) {
  return stepping == wire::ChipStepping::kB2;
}

}  // namespace kaori::rp2040
