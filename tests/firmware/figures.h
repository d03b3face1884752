// Figures of a test run, for out/firmware.json.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>

namespace kaori::proof {

// Appends "name value" to the file that KAORI_FIRMWARE_FIGURES names; without it, does nothing.
inline void Figure(const std::string& name, std::uint64_t value) {
  if (const char* path = std::getenv("KAORI_FIRMWARE_FIGURES"))
    std::ofstream(path, std::ios::app) << name << ' ' << value << '\n';
}

// How much is proved: KAORI_FIRMWARE_EFFORT times as much, 1 where it is not set.
inline std::uint32_t Effort() {
  const char* effort = std::getenv("KAORI_FIRMWARE_EFFORT");
  return effort != nullptr ? static_cast<std::uint32_t>(std::strtoul(effort, nullptr, 10)) : 1;
}

}  // namespace kaori::proof
