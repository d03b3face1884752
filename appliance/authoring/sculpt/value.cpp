#include "appliance/authoring/sculpt/value.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include "drivers/base/read_file.h"

namespace kaori::sculpt {
namespace {

Result<Value> Convert(const toml::node& node, const std::string& file);

int LineOf(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

Result<Value> ConvertList(const toml::array& array, const std::string& file) {
  Value value{.kind = Value::Kind::kList, .line = LineOf(array)};
  for (const toml::node& item : array) {
    Result<Value> converted = Convert(item, file);
    if (!converted) return converted;
    value.list.push_back(std::move(*converted));
  }
  return value;
}

Result<Value> ConvertTable(const toml::table& table, const std::string& file) {
  Value value{.kind = Value::Kind::kTable, .line = LineOf(table)};
  for (const auto& [key, item] : table) {
    Result<Value> converted = Convert(item, file);
    if (!converted) return converted;
    value.table.emplace_back(std::string(key.str()), std::move(*converted));
  }
  return value;
}

Result<Value> Convert(const toml::node& node, const std::string& file) {
  if (const toml::array* array = node.as_array()) return ConvertList(*array, file);
  if (const toml::table* table = node.as_table()) return ConvertTable(*table, file);
  Value value{.line = LineOf(node)};
  if (node.is_number()) {
    value.kind = Value::Kind::kNumber;
    value.number = node.value<double>().value_or(NAN);
    if (std::isfinite(value.number)) return value;
    return FailInput(fmt::format("{}:{}: a number that is not finite", file, value.line));
  }
  if (node.is_string()) {
    value.kind = Value::Kind::kWord;
    value.word = node.value<std::string>().value_or("");
    return value;
  }
  return FailInput(fmt::format("{}:{}: neither a number, a word, a list nor a table", file, value.line));
}

}  // namespace

Result<Value> ReadToml(const std::filesystem::path& file) {
  const auto text = ReadFile(file, {.most_levels = kMostLevels});
  if (!text) return tl::unexpected(text.error());
  const toml::parse_result parsed = toml::parse(*text, file.string());
  if (!parsed) {
    const toml::parse_error& error = parsed.error();
    return FailInput(fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
  return ConvertTable(parsed.table(), file.string());
}

}  // namespace kaori::sculpt
