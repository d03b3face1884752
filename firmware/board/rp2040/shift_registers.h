// Four 74HC165 that read 32 switches and four 74HC595 that drive 32 lamps, on one SPI and one strobe.
#pragma once

#include <cstdint>

namespace kaori::rp2040 {

// 7.8 MHz: an exchange takes 5 us. One side.
class ShiftRegisters {
 public:
  // Its pins are set up.
  static void Start();
  // Reads all switches, bit n: switch n is closed; and shows `lamps` from the next exchange on. The strobe
  // that loads the switches is the one that puts out what was shifted before.
  static std::uint32_t Exchange(std::uint32_t lamps);
};

}  // namespace kaori::rp2040
