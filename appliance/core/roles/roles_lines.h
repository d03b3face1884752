// The lines of the box's own roles.toml, into which what was taught is written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/show/roles.h"
#include "appliance/core/toml/value.h"
#include "drivers/base/result.h"

namespace kaori::roles {

// Lines that nobody replaces stay as they are, comments as well. Errors of its members, all invalid_argument
// (kInput): the text is no TOML, or its tables have no lines of their own, [[role]], [[role.map]] and
// [[button]]. What was written is to be read back before it is believed: only the beginning of each table is
// known.
class RolesLines {
 public:
  // `file` is what messages call it.
  RolesLines(std::string_view text, std::string file);
  std::string text() const;

  // Of this role `maps`, texts of [[role.map]], are all that is said of the level. `device` is written where
  // the file has no such role yet; none: the role has that of the file below.
  Result<void> SetMaps(const std::string& role, std::optional<show::Device> device, const std::string& level,
                       const std::vector<std::string>& maps);

  // `call` is what the button (show::kAllButtonCount) calls.
  Result<void> SetButton(std::uint8_t button, const std::string& call);

 private:
  // A table, counted from 0: its header and the line behind its last one.
  struct Span {
    std::size_t first = 0, end = 0;
  };
  // Where tables of the whole file begin, in their order.
  std::vector<std::size_t> Begins(const toml::Value& file) const;
  Result<Span> SpanOf(const toml::Value& table, std::string_view header,
                      const std::vector<std::size_t>& begins) const;
  // Removes a table, but not the comments that follow it; gives how many lines that were.
  std::size_t Remove(Span span);
  Result<std::size_t> RemoveMaps(const toml::Value& role, const std::string& level, std::size_t end);
  void AddMaps(std::size_t end, const std::vector<std::string>& maps);
  void AddTable(const std::string& table);

  std::string file_;
  std::vector<std::string> lines_;
};

}  // namespace kaori::roles
