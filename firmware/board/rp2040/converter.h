// An MCP3208 on SPI1: the stick's potentiometers. The chip's own converter jumps at some codes (RP2040-E11),
// which a slow turn of a head would show.
#pragma once

#include <cstdint>

namespace kaori::rp2040 {

// One side.
class Converter {
 public:
  // Its pins are set up.
  static void Start();
  // The code of one of eight channels, 12 bits. Takes 25 us.
  static std::uint16_t Read(unsigned channel);
};

}  // namespace kaori::rp2040
