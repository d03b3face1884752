#include "appliance/authoring/script/taken_keys.h"

#include <algorithm>
#include <array>

#include "appliance/core/board/keys.h"

namespace kaori::authoring {
namespace {

namespace key = board::key;

// A key and what the box does with it.
struct TakenKey {
  std::uint16_t usage;  // HID usage page 7.
  std::string_view use;
};

constexpr std::string_view kWinks = "it winks", kEditor = "the expression editor uses it";
// Space has no name in show.toml, so it need not stand here.
constexpr std::array<TakenKey, 10> kTakenKeys{{{key::kZ, kWinks},
                                               {key::kX, kWinks},
                                               {key::kC, kEditor},
                                               {key::kH, kEditor},
                                               {key::kM, kEditor},
                                               {key::kN, kEditor},
                                               {key::kP, kEditor},
                                               {key::kS, kEditor},
                                               {key::kY, kEditor},
                                               {key::kF12, "it begins the calibration of the lips"}}};

}  // namespace

std::string_view UseOfTheBox(std::uint16_t usage) {
  const auto taken = std::ranges::find(kTakenKeys, usage, &TakenKey::usage);
  return taken == kTakenKeys.end() ? std::string_view() : taken->use;
}

}  // namespace kaori::authoring
