#include "appliance/core/store/refused_usb.h"

#include <algorithm>
#include <array>

namespace kaori::store {
namespace {

// In the order of Weight.
constexpr std::array<std::string_view, 3> kWords{"quiet", "named", "fault"};

// The first line of `text`, which begins with the next one afterwards.
std::string_view NextLine(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

}  // namespace

std::string FormatRefusedUsb(const RefusedUsb& refused) {
  return std::string(kWords[static_cast<std::size_t>(refused.weight)]) + "\n" + refused.english + "\n" +
         refused.japanese + "\n";
}

std::optional<RefusedUsb> ParseRefusedUsb(std::string_view text) {
  const auto* const word = std::ranges::find(kWords, NextLine(text));
  const std::string_view english = NextLine(text), japanese = NextLine(text);
  if (word == kWords.end() || english.empty()) return std::nullopt;
  return RefusedUsb{.weight = static_cast<Weight>(word - kWords.begin()),
                    .english = std::string(english),
                    .japanese = std::string(japanese)};
}

}  // namespace kaori::store
