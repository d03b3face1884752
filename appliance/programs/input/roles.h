// Which stick plays which part: a role belongs to a port, so two equal sticks never swap.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kaori::input {

inline constexpr int kSticks = 2;

// Never 0. Stands on the board for the port's name.
std::uint32_t HashOfPort(std::string_view port);

// "1-2" comes before "1-10": digits count as numbers.
bool PortBefore(std::string_view a, std::string_view b);

// One thread.
class StickRoles {
 public:
  // `named` are the ports that the settings give to the left and the right stick; empty: open to any port.
  // `before` are hashes of the ports that had the roles before this program started; 0 is none.
  StickRoles(const std::array<std::string, kSticks>& named, const std::array<std::uint32_t, kSticks>& before);

  // The role of a stick at `port`, or nothing while it is a spare. A port that the settings name, that is
  // called "stick-left" or "stick-right", or that had a role before, has that role for good. Another takes
  // the first role that never had a port, else the first that is empty, and keeps it.
  std::optional<int> RoleOf(std::string_view port, const std::array<bool, kSticks>& taken);

 private:
  std::optional<int> Known(std::uint32_t hash) const;
  std::optional<int> FirstOpen(const std::array<bool, kSticks>& taken, bool remembered) const;

  std::array<std::uint32_t, kSticks> named_{};
  std::array<std::uint32_t, kSticks> last_{};
};

}  // namespace kaori::input
