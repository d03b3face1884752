#include "hw-sim/scenario/key_names.h"

#include <array>
#include <cctype>

#include "drivers/base/number.h"

namespace kaori::sim {
namespace {

// What people write, and what a report says.
struct Key {
  std::string_view name;
  std::uint8_t usage;
};

// USB HID Usage Tables 1.3, page 7. Names are those of a US keyboard: a key is a place.
constexpr auto kKeys = std::to_array<Key>({
    {"enter", 0x28},      {"escape", 0x29},      {"backspace", 0x2A}, {"tab", 0x2B},
    {"space", 0x2C},      {"minus", 0x2D},       {"equal", 0x2E},     {"comma", 0x36},
    {"period", 0x37},     {"slash", 0x38},       {"insert", 0x49},    {"home", 0x4A},
    {"page-up", 0x4B},    {"delete", 0x4C},      {"end", 0x4D},       {"page-down", 0x4E},
    {"right", 0x4F},      {"left", 0x50},        {"down", 0x51},      {"up", 0x52},
    {"left-ctrl", 0xE0},  {"left-shift", 0xE1},  {"left-alt", 0xE2},  {"left-gui", 0xE3},
    {"right-ctrl", 0xE4}, {"right-shift", 0xE5}, {"right-alt", 0xE6}, {"right-gui", 0xE7},
});

constexpr std::string_view kDigits = "1234567890";  // In the order of the usages from 1E.
// Of keys without a name of their own.
constexpr std::string_view kUsage = "usage-";

// By direction, from 0.
constexpr std::array<std::string_view, 8> kHats{"up",   "up-right",  "right", "down-right",
                                                "down", "down-left", "left",  "up-left"};

std::string Lower(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// a to z, and the digits.
std::optional<std::uint8_t> OneLetter(char c) {
  if (c >= 'a' && c <= 'z') return static_cast<std::uint8_t>(0x04 + (c - 'a'));
  const auto digit = kDigits.find(c);
  if (digit == std::string_view::npos) return std::nullopt;
  return static_cast<std::uint8_t>(0x1E + digit);
}

}  // namespace

// 0x3A is F1. Numbers below 0x04 are errors that keyboards report, and above 0xE7 there is no key.
std::optional<std::uint8_t> KeyNamed(std::string_view name) {
  const std::string lower = Lower(name);
  if (lower.size() == 1) return OneLetter(lower[0]);
  for (const Key& key : kKeys) {
    if (key.name == lower) return key.usage;
  }
  if (lower.starts_with('f')) {
    const auto number = ParseNumber<int>(std::string_view(lower).substr(1));
    if (number && *number >= 1 && *number <= 12) return static_cast<std::uint8_t>(0x3A + *number - 1);
  }
  if (lower.starts_with(kUsage)) {
    const auto number = ParseNumber<int>(std::string_view(lower).substr(kUsage.size()));
    if (number && *number >= 0x04 && *number <= 0xE7) return static_cast<std::uint8_t>(*number);
  }
  return std::nullopt;
}

// The order of KeyNamed, so that each name is read back as its usage.
std::string KeyName(std::uint8_t usage) {
  if (usage >= 0x04 && usage <= 0x1D) return std::string(1, static_cast<char>('a' + usage - 0x04));
  if (usage >= 0x1E && usage <= 0x27) return std::string(1, kDigits[static_cast<std::size_t>(usage - 0x1E)]);
  if (usage >= 0x3A && usage <= 0x45) return "f" + std::to_string(usage - 0x3A + 1);
  for (const Key& key : kKeys) {
    if (key.usage == usage) return std::string(key.name);
  }
  return std::string(kUsage) + std::to_string(usage);
}

std::optional<int> HatNamed(std::string_view name) {
  if (name == "centre") return -1;
  for (std::size_t n = 0; n < kHats.size(); ++n) {
    if (kHats[n] == name) return static_cast<int>(n);
  }
  return std::nullopt;
}

std::string_view HatName(int direction) {
  if (direction < 0 || direction >= static_cast<int>(kHats.size())) return "centre";
  return kHats[static_cast<std::size_t>(direction)];
}

}  // namespace kaori::sim
