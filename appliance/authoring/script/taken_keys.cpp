#include "appliance/authoring/script/taken_keys.h"

#include <algorithm>
#include <array>

namespace kaori::authoring {
namespace {

// A key and what the box does with it.
struct TakenKey {
  std::uint16_t usage;  // HID usage page 7.
  std::string_view use;
};

constexpr std::string_view kEditor = "the expression editor uses it";
// Space has no name in show.toml, so it need not stand here.
constexpr std::array<TakenKey, 10> kTakenKeys{{{0x1D, "it winks"},                                 // z
                                               {0x1B, "it winks"},                                 // x
                                               {0x06, kEditor},                                    // c
                                               {0x0B, kEditor},                                    // h
                                               {0x10, kEditor},                                    // m
                                               {0x11, kEditor},                                    // n
                                               {0x13, kEditor},                                    // p
                                               {0x16, kEditor},                                    // s
                                               {0x1C, kEditor},                                    // y
                                               {0x45, "it begins the calibration of the lips"}}};  // f12

}  // namespace

std::string_view UseOfTheBox(std::uint16_t usage) {
  const auto taken = std::ranges::find(kTakenKeys, usage, &TakenKey::usage);
  return taken == kTakenKeys.end() ? std::string_view() : taken->use;
}

}  // namespace kaori::authoring
