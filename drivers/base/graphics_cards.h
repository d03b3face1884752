// Which of a machine's graphics cards screens are plugged into: a chip may draw by one and show by another.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace kaori {

// What a program takes for a card's file to be told which one: the one with screens.
inline constexpr const char* kCardWithScreens = "auto";

// The name in /dev/dri, as in "card1", of the first card by its number that has connectors, whether or not a screen is plugged into
// one: "card0" on a PC with one card. A card that only draws, as a Raspberry Pi's v3d, has none. `cards` is the
// kernel's list, /sys/class/drm. None where no card has any yet, or where the list cannot be read. Opens no card; blocks for nothing;
// any thread.
std::optional<std::string> CardWithScreens(const std::filesystem::path& cards);

// A card's file as a program was told it: that of the card with screens in place of kCardWithScreens, empty where there is none
// yet; any other is itself. Any thread.
std::string CardFile(const std::string& told);

}  // namespace kaori
