// TOML files that people write, as plain values: numbers, texts, switches, lists and tables, each with the
// line it stands on. This folder alone includes the TOML library, which takes seconds to compile; shows,
// settings and the box's own expressions are read through it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::toml {

// One value of a file. Only the member of its kind is filled in.
struct Value {
  enum class Kind { kNumber, kText, kSwitch, kList, kTable };
  Kind kind = Kind::kTable;
  // Positions are the parser's; the value of a key begins behind its "=".
  int line = 0;  // Where the value begins, counted from 1; of a table written [name], its header.
  int column = 0;
  double number = 0;  // Finite. Whole numbers are exact up to 2^53.
  bool on = false;    // true.
  std::string text{};
  std::vector<Value> list{};
  std::vector<std::pair<std::string, Value>> table{};  // In the order of their names.
};

// The value under `key` of a table; null where there is none. Borrows `table`.
const Value* Find(const Value& table, std::string_view key);

// Reads TOML into a table. `file` is what messages call it. Errors:
//   bad_message       tables nest deeper than kMostLevels (kInput)
//   invalid_argument  the text is no TOML, or holds a number that is not finite or a date (kInput); the attempt
//                     says "file:line: reason"
// Only the first fault of the syntax is told, as the parser gives it. The result owns all of its texts.
Result<Value> Parse(std::string_view text, const std::string& file);

// ReadFile, which blocks for the disk, then Parse. Errors: as both.
Result<Value> ReadToml(const std::filesystem::path& file);

}  // namespace kaori::toml
