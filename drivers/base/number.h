// Numbers in texts that people and other programs write.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace kaori {

// The number that all of `text` is, in decimal digits and without spaces or a plus sign; none where it is
// anything else or does not fit. A floating-point number may be an infinity or no number, which comparisons
// refuse.
template <class Number>
std::optional<Number> ParseNumber(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace kaori
