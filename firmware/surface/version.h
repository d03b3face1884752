// The version of the control surfaces' firmware. firmware/images.py reads these lines.
#pragma once

#include <cstdint>

namespace kaori::surface {

inline constexpr std::uint16_t kVersionMajor = 1;
inline constexpr std::uint16_t kVersionMinor = 1;
// Major * 65536 + minor: older images are refused, for what lies in flash would not suit them.
inline constexpr std::uint32_t kOldestVersion = 0x10000;

}  // namespace kaori::surface
