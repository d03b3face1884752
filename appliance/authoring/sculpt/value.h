// What stands in a file that people write: numbers, words, lists and tables, each with the line it stands on.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::sculpt {

struct Value {
  enum class Kind { kNumber, kWord, kList, kTable };
  Kind kind = Kind::kTable;
  int line = 0;
  double number = 0;  // Finite.
  std::string word{};
  std::vector<Value> list{};
  std::vector<std::pair<std::string, Value>> table{};  // In the order of their names.
};

// Reads a TOML file into a table. Errors: those of ReadFile, and
//   invalid_argument           it is no TOML, or holds a number that is not finite, or a date: file and line
//   are named
Result<Value> ReadToml(const std::filesystem::path& file);

}  // namespace kaori::sculpt
