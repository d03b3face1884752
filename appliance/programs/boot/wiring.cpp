#include "appliance/programs/boot/wiring.h"

#include <algorithm>
#include <cctype>

#include "drivers/base/number.h"

namespace kaori::boot {
namespace {

// The bounds of kaori-input (input/line_roles.h) for lines, and of the kernel (GPIO_MAX_NAME_SIZE is 32) for
// labels.
constexpr int kMostLine = 63;
constexpr std::size_t kLongestLabel = 32;

// A string of TOML without escapes, which neither labels nor "none" need.
std::optional<std::string_view> Unquoted(std::string_view value) {
  if (value.size() < 2 || value.front() != '"' || value.back() != '"') return std::nullopt;
  return value.substr(1, value.size() - 2);
}

// The letters that chips of the kernel have in their labels. The text goes into an environment file of
// systemd, so that quotes and blanks are kept out.
bool IsLabel(std::string_view text) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.'; };
  return !text.empty() && text.size() <= kLongestLabel && std::ranges::all_of(text, fits);
}

// Returns why the value is refused, or nothing; so does ParseWire.
std::string ParseChip(std::string_view value, std::string& chip) {
  const auto label = Unquoted(value);
  if (!label || !IsLabel(*label)) return "expected a chip's label in quotes";
  chip = *label;
  return {};
}

}  // namespace

// A line may be set twice: the last word counts, as the default is set before the file is read.
std::string ParseWire(std::string_view key, std::string_view value, Wiring& wiring) {
  if (key == "chip") return ParseChip(value, wiring.chip);
  const auto name = std::ranges::find(kLineNames, key);
  if (name == kLineNames.end()) return "there is no line " + std::string(key);
  auto& line = wiring.lines[static_cast<std::size_t>(name - kLineNames.begin())];
  if (Unquoted(value) == "none") {
    line.reset();
    return {};
  }
  const auto number = ParseNumber<int>(value);
  if (!number || *number < 0 || *number > kMostLine) return "expected a number of 0 to 63, or \"none\"";
  line = number;
  return {};
}

// The kernel would refuse the second request for a line when the box starts; here the settings file is named.
std::string CheckWiring(const Wiring& wiring) {
  for (std::size_t a = 0; a < kLineNames.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (wiring.lines[a] && wiring.lines[a] == wiring.lines[b])
        return std::string(kLineNames[b]) + " and " + std::string(kLineNames[a]) + " are one line";
  return {};
}

// In systemd's form of an EnvironmentFile. Without any line the chip is empty, and kaori-input then opens
// none.
std::string EnvironmentOf(const Wiring& wiring) {
  std::string words;
  for (std::size_t n = 0; n < kLineNames.size(); ++n) {
    if (!wiring.lines[n]) continue;
    words += words.empty() ? "" : ",";
    words += std::string(kLineNames[n]) + "=" + std::to_string(*wiring.lines[n]);
  }
  return "KAORI_CHIP=" + (words.empty() ? "" : wiring.chip) + "\nKAORI_LINES=" + words + "\n";
}

}  // namespace kaori::boot
