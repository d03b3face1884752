// USB devices that a box does not know, for the check that it judges them.
#pragma once

#include <cstdint>
#include <vector>

#include "hw-sim/devices/unknown_device.h"

namespace kaori::hil {

// A device that says it is what it is not, or something that a box has no role for.
struct Unknown {
  const char* name;
  std::uint16_t vendor;
  std::uint16_t product;
  std::vector<sim::UsbInterface> interfaces;
  bool wanted = false;  // The honest ones among them.
  // In place of `interfaces` a whole configuration; empty: none.
  sim::UsbBytes configuration{};
};

// To be plugged in one after another: two of them carry one number.
std::vector<Unknown> UnknownDevices();

}  // namespace kaori::hil
