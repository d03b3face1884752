#include "appliance/authoring/import/role_names.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kaori::import {

using face::ExpressionKind;

std::string MadeOf(const Heads& heads, const Role& role) {
  std::vector<std::string> parts;
  for (const RolePart& part : role.parts)
    parts.push_back(fmt::format("{} x {}", part.weight, heads.shapes[part.shape].name));
  return fmt::format("{}: {}", NameOf(role.style), fmt::join(parts, " + "));
}

std::string MeaningIn(const Shape& shape) {
  return shape.meaning ? fmt::format("{} {}", NameOf(shape.meaning->style), shape.meaning->name) : "";
}

const Role* FindRole(const Heads& heads, std::string_view name) {
  const auto role = std::ranges::find(heads.roles, name, &Role::name);
  return role == heads.roles.end() ? nullptr : &*role;
}

// "neutral" and the brows are not in either list: channels.
ExpressionKind KindOfRole(std::string_view role) {
  constexpr std::array<std::string_view, 4> kCalled{"smile", "angry", "sad", "surprised"};
  constexpr std::array<std::string_view, 7> kMouths{"a", "i", "u", "e", "o", "m", "f"};
  if (std::ranges::find(kCalled, role) != kCalled.end()) return ExpressionKind::kExpression;
  const bool mouth = std::ranges::find(kMouths, role) != kMouths.end() || role.starts_with("mouth_");
  return mouth ? ExpressionKind::kMouth : ExpressionKind::kChannel;
}

}  // namespace kaori::import
