// Names of a fixed list in a file.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/toml/section.h"

namespace kaori::roles {

// The index of `name` among `names`, or a fault of `key` that lists them all.
template <std::size_t kCount>
std::optional<std::size_t> IndexOf(toml::Section& section, std::string_view key, const std::string& name,
                                   const std::array<std::string_view, kCount>& names) {
  const auto* const found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  section.Fault(key, fmt::format("\"{}\" is none of {}", name, fmt::join(names, ", ")));
  return std::nullopt;
}

}  // namespace kaori::roles
