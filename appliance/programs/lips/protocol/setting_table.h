// The settings of the lips by number and name, with their ranges: what a file, a packet and a page agree on.
// It is a leaf that kaori-desk links without the rest of the lips.
#pragma once

#include <cstddef>
#include <string_view>

namespace kaori::lips {

// The unit and the meaning of each value stand at LipSettings (appliance/programs/lips/lip_settings.h).
struct SettingRange {
  std::string_view name;  // As in the settings file: "key.similarity".
  float low;              // Both ends are allowed.
  float high;
};

// How many settings there are. Their numbers, 0 to kSettingCount - 1, are their order in the settings file.
inline constexpr std::size_t kSettingCount = 16;

// `setting` must be below kSettingCount.
SettingRange RangeOf(std::size_t setting);

}  // namespace kaori::lips
