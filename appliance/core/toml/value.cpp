#include "appliance/core/toml/value.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
// Nothing of ours throws: the parser then gives its error as a value.
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include "drivers/base/read_file.h"

namespace kaori::toml {
namespace {

Result<Value> Convert(const ::toml::node& node, const std::string& file);

// A value with its kind and the position that the parser noted for its beginning.
Value Begin(Value::Kind kind, const ::toml::node& node) {
  const auto& begin = node.source().begin;
  return {.kind = kind, .line = static_cast<int>(begin.line), .column = static_cast<int>(begin.column)};
}

// The first item that cannot be converted ends the list; the error has its line. Of tables the same.
Result<Value> ConvertList(const ::toml::array& array, const std::string& file) {
  Value value = Begin(Value::Kind::kList, array);
  for (const ::toml::node& item : array) {
    Result<Value> converted = Convert(item, file);
    if (!converted) return converted;
    value.list.push_back(std::move(*converted));
  }
  return value;
}

Result<Value> ConvertTable(const ::toml::table& table, const std::string& file) {
  Value value = Begin(Value::Kind::kTable, table);
  for (const auto& [key, item] : table) {
    Result<Value> converted = Convert(item, file);
    if (!converted) return converted;
    value.table.emplace_back(std::string(key.str()), std::move(*converted));
  }
  return value;
}

// Whole numbers and fractions are one kind here, as people write them. TOML knows nan and inf: no value of
// ours may be one.
Result<Value> ConvertNumber(const ::toml::node& node, const std::string& file) {
  Value value = Begin(Value::Kind::kNumber, node);
  value.number = node.value<double>().value_or(NAN);
  if (!std::isfinite(value.number))
    return FailInput(fmt::format("{}:{}: a number that is not finite", file, value.line));
  return value;
}

// Calls itself once a level; CheckLevels has bounded those before the parser ran.
Result<Value> Convert(const ::toml::node& node, const std::string& file) {
  if (const ::toml::array* array = node.as_array()) return ConvertList(*array, file);
  if (const ::toml::table* table = node.as_table()) return ConvertTable(*table, file);
  if (node.is_number()) return ConvertNumber(node, file);
  if (node.is_boolean()) {
    Value value = Begin(Value::Kind::kSwitch, node);
    value.on = node.value<bool>().value_or(false);
    return value;
  }
  if (node.is_string()) {
    Value value = Begin(Value::Kind::kText, node);
    value.text = node.value<std::string>().value_or("");
    return value;
  }
  return FailInput(fmt::format("{}:{}: a date or a time; a number, a text, a list or a table is expected",
                               file, node.source().begin.line));
}

}  // namespace

const Value* Find(const Value& table, std::string_view key) {
  const auto found = std::ranges::find(table.table, key, &std::pair<std::string, Value>::first);
  return found == table.table.end() ? nullptr : &found->second;
}

Result<Value> Parse(std::string_view text, const std::string& file) {
  if (auto ok = CheckLevels(text, kMostLevels, file); !ok) return tl::unexpected(ok.error());
  const ::toml::parse_result parsed = ::toml::parse(text, file);
  if (!parsed) {
    const ::toml::parse_error& error = parsed.error();
    return FailInput(fmt::format("{}:{}: {}", file, error.source().begin.line, error.description()));
  }
  return ConvertTable(parsed.table(), file);
}

Result<Value> ReadToml(const std::filesystem::path& file) {
  const auto text = ReadFile(file);
  if (!text) return tl::unexpected(text.error());
  return Parse(*text, file.string());
}

}  // namespace kaori::toml
