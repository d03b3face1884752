#include "appliance/programs/lips/protocol/setting_table.h"

#include <array>

namespace kaori::lips {
namespace {

// The order is that of the settings file, of Report::values and of the accessors in lip_settings.cpp. A
// setting that is inserted changes the protocol, and with it the letters of its packets.
constexpr std::array<SettingRange, kSettingCount> kRanges{{
    {"paint.red", 0, 255},
    {"paint.green", 0, 255},
    {"paint.blue", 0, 255},
    {"key.similarity", 1, 1000},
    {"key.smoothness", 1, 1000},
    {"key.spill", 1, 1000},
    {"marker", 0, 1},
    {"rest_width", 0, 0.95F},
    {"smoothing.least_cutoff_hz", 0.1F, 100},
    {"smoothing.cutoff_per_speed", 0, 1000},
    {"mouth.shut", 0, 2},
    {"mouth.open", 0.05F, 4},
    {"mouth.narrow", 0.1F, 0.99F},
    {"mouth.wide", 1.01F, 4},
    {"voice.opens_db", -80, 0},
    {"sound.delay_ms", -1, 500},
}};

}  // namespace

// Not checked: a number that is too large reads beyond the table.
SettingRange RangeOf(std::size_t setting) {
  return kRanges[setting];
}

}  // namespace kaori::lips
