#include "appliance/programs/input/stick_roles.h"

#include <cctype>
#include <cstddef>

#include "drivers/base/checksum.h"

namespace kaori::input {
namespace {

// Ports whose names say which stick they hold, as those of the simulator do.
constexpr std::array<std::string_view, kSticks> kOwnPorts{"stick-left", "stick-right"};

bool Digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// Removes a run of digits, or one other character, from the front of `text` and returns it.
std::string_view SplitFirstPart(std::string_view& text) {
  std::size_t length = 1;
  if (Digit(text[0]))
    while (length < text.size() && Digit(text[length])) ++length;
  const std::string_view part = text.substr(0, length);
  text.remove_prefix(length);
  return part;
}

// Numbers of different length are ordered by it, since port names have no leading zeros.
bool PartBefore(std::string_view a, std::string_view b) {
  const bool numbers = Digit(a[0]) && Digit(b[0]);
  if (numbers && a.size() != b.size()) return a.size() < b.size();
  return a < b;
}

}  // namespace

std::uint32_t HashOfPort(std::string_view port) {
  const auto hash = static_cast<std::uint32_t>(Fnv1a(port));
  return hash == 0 ? 1 : hash;
}

// A name that begins with the other one comes after it.
bool PortBefore(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    const std::string_view left = SplitFirstPart(a);
    const std::string_view right = SplitFirstPart(b);
    if (left != right) return PartBefore(left, right);
  }
  return a.size() < b.size();
}

// Ports are compared by their hashes, which stand for the names on the board.
StickRoles::StickRoles(const std::array<std::string, kSticks>& named,
                       const std::array<std::uint32_t, kSticks>& before)
    : last_(before) {
  for (std::size_t role = 0; role < named.size(); ++role)
    if (!named[role].empty()) named_[role] = HashOfPort(named[role]);
}

// A known port whose role is occupied belongs to a second device of the same name, and stays a spare: roles
// never wander. A role that never had a port is given first, so that a third socket does not take over the
// role of a stick that was pulled for a moment.
std::optional<int> StickRoles::RoleOf(std::string_view port, const std::array<bool, kSticks>& occupied) {
  const std::uint32_t hash = HashOfPort(port);
  auto role = Known(hash);
  if (role && occupied[static_cast<std::size_t>(*role)]) return std::nullopt;
  if (!role && (role = FirstOpen(occupied, /*remembered=*/false)) == 0) first_left_ = port;
  if (!role) role = FirstOpen(occupied, /*remembered=*/true);
  if (role) last_[static_cast<std::size_t>(*role)] = hash;
  return role;
}

bool StickRoles::IsBeforeLeft(std::string_view port) const {
  return !first_left_.empty() && named_[1] == 0 && last_[1] == 0 && !Known(HashOfPort(port)) &&
         PortBefore(port, first_left_);
}

void StickRoles::MoveLeftToRight() {
  last_ = {0, last_[0]};
  first_left_.clear();
}

// What the settings name comes before what was remembered, for both roles.
std::optional<int> StickRoles::Known(std::uint32_t hash) const {
  for (int role = 0; role < kSticks; ++role)
    if (named_[static_cast<std::size_t>(role)] == hash) return role;
  for (int role = 0; role < kSticks; ++role) {
    const auto i = static_cast<std::size_t>(role);
    if (named_[i] == 0 && (last_[i] == hash || HashOfPort(kOwnPorts[i]) == hash)) return role;
  }
  return std::nullopt;
}

// A role that the settings give to a port is never given to another one.
std::optional<int> StickRoles::FirstOpen(const std::array<bool, kSticks>& occupied, bool remembered) const {
  for (int role = 0; role < kSticks; ++role) {
    const auto i = static_cast<std::size_t>(role);
    if (!occupied[i] && named_[i] == 0 && (last_[i] != 0) == remembered) return role;
  }
  return std::nullopt;
}

}  // namespace kaori::input
