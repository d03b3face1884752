#include "appliance/programs/status/screens_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

namespace kaori::status {
namespace {

using ports::ModeOrigin;
using ports::Output;
using ports::OutputState;

// A graphics card has a dozen connectors at most; the bound is for a file that is none.
constexpr std::size_t kMostScreens = 64;
constexpr std::array kOrigins{std::pair{ModeOrigin::kWanted, "wanted"},
                              std::pair{ModeOrigin::kSubstitute, "substitute"},
                              std::pair{ModeOrigin::kSafeGuess, "safe"}};
constexpr std::array kStates{
    std::pair{OutputState::kShowsPicture, "picture"}, std::pair{OutputState::kUnplugged, "unplugged"},
    std::pair{OutputState::kShowsStatus, "status"}, std::pair{OutputState::kShowsMonitor, "monitor"}};

// The word of a value; that of the first one for a value that is none.
template <class Value, std::size_t kCount>
const char* NameIn(const std::array<std::pair<Value, const char*>, kCount>& names, Value value) {
  for (const auto& [each, name] : names)
    if (each == value) return name;
  return names.front().second;
}

template <class Value, std::size_t kCount>
std::optional<Value> ValueIn(const std::array<std::pair<Value, const char*>, kCount>& names,
                             const char* name) {
  for (const auto& [value, each] : names)
    if (std::strcmp(each, name) == 0) return value;
  return std::nullopt;
}

// The widths in the format keep each word within its array; a longer word makes the rest fail to fit.
std::optional<Output> ParseScreen(const std::string& line) {
  std::array<char, 64> connector{};
  std::array<char, 16> origin{}, state{};
  Output output;
  const int read = std::sscanf(line.c_str(), "%63s %dx%d %lf %15s %15s", connector.data(), &output.width_px,
                               &output.height_px, &output.rate_hz, origin.data(), state.data());
  const auto known_origin = ValueIn(kOrigins, origin.data());
  const auto known_state = ValueIn(kStates, state.data());
  if (read != 6 || !known_origin || !known_state) return std::nullopt;
  output.connector = connector.data();
  output.origin = *known_origin;
  output.state = *known_state;
  return output;
}

}  // namespace

// A connector's name has no blanks: the kernel makes it of letters, digits and dashes.
std::string FormatScreens(std::span<const Output> outputs) {
  std::string text;
  for (const Output& output : outputs)
    text += fmt::format("{} {}x{} {} {} {}\n", output.connector, output.width_px, output.height_px,
                        output.rate_hz, NameIn(kOrigins, output.origin), NameIn(kStates, output.state));
  return text;
}

// The order is kept: it is that of the outputs' parts of the picture.
std::vector<Output> ParseScreens(std::string_view text) {
  std::vector<Output> outputs;
  while (!text.empty() && outputs.size() < kMostScreens) {
    const auto line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (auto output = ParseScreen(std::string(line))) outputs.push_back(std::move(*output));
  }
  return outputs;
}

}  // namespace kaori::status
