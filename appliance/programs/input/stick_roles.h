// Which stick has which role: a role belongs to a port, so that two equal sticks never swap.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kaori::input {

inline constexpr int kSticks = 2;

// A 32-bit FNV-1a hash of a port's name, which stands for the name on the board. It is never 0.
std::uint32_t HashOfPort(std::string_view port);

// The order of port names in which digits count as numbers: "1-2" comes before "1-10".
bool PortBefore(std::string_view a, std::string_view b);

// Pure: it remembers ports and asks no device. One thread. What it remembers is kept on the board by the
// slots (Stick::port), so that it holds over restarts of the program, and is forgotten with the board.
class StickRoles {
 public:
  // `named` are the ports that the settings give to the left and the right stick; an empty name leaves the
  // role open to any port. `before` are HashOfPort of the ports that had the roles before this program
  // started; 0 is none.
  StickRoles(const std::array<std::string, kSticks>& named, const std::array<std::uint32_t, kSticks>& before);

  // Returns the role (0 left, 1 right) of a stick at `port`, or nothing while it is a spare. A port that the
  // settings name, that is called "stick-left" or "stick-right", or that had a role before, always has that
  // role. Any other port gets the first role that never had a port, or else the first one that is not
  // `occupied`, and keeps it.
  std::optional<int> RoleOf(std::string_view port, const std::array<bool, kSticks>& occupied);

  // Whether the left stick got its role in this run because it was the first one, although `port`, which nobody knew, comes before
  // its port; the right role has been nobody's yet. At power on it is chance which of two sticks the kernel lists first.
  bool IsBeforeLeft(std::string_view port) const;
  // The left stick's port has the right role from now on, where IsBeforeLeft.
  void MoveLeftToRight();

 private:
  // The role that belongs to this port by the settings, by its name, or by what was there before.
  std::optional<int> Known(std::uint32_t hash) const;
  // The first free role that no setting names and that had a port before, or never had one.
  std::optional<int> FirstOpen(const std::array<bool, kSticks>& occupied, bool remembered) const;

  // Hashes, by role; 0 is none. named_ is from the settings, last_ from the last stick that had the role.
  std::array<std::uint32_t, kSticks> named_{};
  std::array<std::uint32_t, kSticks> last_{};
  // The port that got the left role as the first of all; empty where it is known by anything else.
  std::string first_left_;
};

}  // namespace kaori::input
