// Which line of which GPIO chip is what, as the box's settings say in their section [lines].
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace kaori::boot {

// What a line can be. kaori-input knows the same names (input/line_roles.h); the two programs share no code.
inline constexpr std::array<std::string_view, 7> kLineNames{"go",    "blackout", "service", "presence",
                                                            "tally", "back",     "panic"};

// The default is the box's own USB bridge with the first five lines in order. BACK and PANIC are wired where the
// settings say so: a box whose settings are older may have anything there.
struct Wiring {
  // The chip's label, as gpioinfo(1) shows it.
  std::string chip = "cp2112_gpio";
  // The chip's line for each of kLineNames; nothing: not wired.
  std::array<std::optional<int>, kLineNames.size()> lines{0, 1, 2, 3, 4, {}, {}};
  friend bool operator==(const Wiring&, const Wiring&) = default;
};

// Takes one setting: chip = "label", or go = 0, or go = "none". Says what is wrong with it, or nothing.
std::string ParseWire(std::string_view key, std::string_view value, Wiring& wiring);

// What is wrong with all of it together, or nothing: one line that is two things.
std::string CheckWiring(const Wiring& wiring);

// For kaori-input's unit: KAORI_CHIP, empty where nothing is wired, and KAORI_LINES.
std::string EnvironmentOf(const Wiring& wiring);

}  // namespace kaori::boot
