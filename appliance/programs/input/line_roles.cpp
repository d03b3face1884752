#include "appliance/programs/input/line_roles.h"

#include <algorithm>
#include <string>
#include <utility>

#include "drivers/base/number.h"

namespace kaori::input {
namespace {

// In the order of board::Line.
constexpr std::array<std::string_view, board::kLineCount> kInputNames{"go",       "blackout", "service",
                                                                      "presence", "back",     "panic"};

// The role of this name, for the caller to fill in; null for an unknown name.
std::optional<std::uint32_t>* RoleNamed(std::string_view name, LineRoles& roles) {
  if (name == "tally") return &roles.tally;
  const auto at = std::ranges::find(kInputNames, name);
  if (at == kInputNames.end()) return nullptr;
  return &roles.inputs[static_cast<std::size_t>(at - kInputNames.begin())];
}

// All of the text must be the number: "1x" is a typing error and not line 1.
std::optional<std::uint32_t> ParseOffset(std::string_view text) {
  const auto offset = ParseNumber<std::uint32_t>(text);
  return offset && *offset <= kMaxOffset ? offset : std::nullopt;
}

// One contact with two roles would be a mistake of the wiring; the kernel would refuse the second request
// anyway, with a message that helps nobody.
bool Has(const LineRoles& roles, std::uint32_t offset) {
  return roles.tally == offset ||
         std::ranges::find(roles.inputs, std::optional(offset)) != roles.inputs.end();
}

// Parses one "go=0" into `roles`. Returns what is wrong with it, or nothing.
std::string ParseRole(std::string_view word, LineRoles& roles) {
  const auto equals = std::min(word.find('='), word.size());
  auto* const role = RoleNamed(word.substr(0, equals), roles);
  if (role == nullptr)
    return "this role is unknown; the roles are go, back, panic, blackout, service, presence and tally";
  const auto offset = equals < word.size() ? ParseOffset(word.substr(equals + 1)) : std::nullopt;
  if (!offset) return "the number of a line from 0 to 63 is missing, as in go=0";
  if (*role || Has(roles, *offset)) return "this role or this line is named twice";
  *role = offset;
  return {};
}

}  // namespace

// A comma at the end leaves an empty word behind it, which is an unknown role.
Result<LineRoles> ParseLineRoles(std::string_view text) {
  LineRoles roles;
  for (bool more = true; more;) {
    const auto comma = text.find(',');
    const auto word = text.substr(0, comma);
    if (const auto wrong = ParseRole(word, roles); !wrong.empty())
      return FailInput("lines, " + std::string(word) + ": " + wrong);
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
  }
  return roles;
}

std::uint32_t WiredInputs(const LineRoles& roles) {
  std::uint32_t wired = 0;
  for (std::size_t n = 0; n < roles.inputs.size(); ++n)
    if (roles.inputs[n]) wired |= 1U << n;
  return wired;
}

}  // namespace kaori::input
