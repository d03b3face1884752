// JSON as plain values: what reports, labels and pages are written with, and read from. No program includes a
// JSON library.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace kaori::json {

class Value;
using List = std::vector<Value>;
using Object = std::vector<
    std::pair<std::string, Value>>;  // In the order in which it is written; names are not compared.

// Null, a switch, a number, a text, a list or an object.
class Value {
 public:
  Value() = default;  // null
  Value(bool on) : value_(on) {}
  template <std::integral Number>
  requires(!std::same_as<Number, bool>) Value(Number number) : value_(static_cast<std::int64_t>(number)) {}
  template <std::floating_point Number>
  Value(Number number) : value_(static_cast<double>(number)) {}
  Value(const char* text) : value_(std::string(text)) {}
  Value(std::string_view text) : value_(std::string(text)) {}
  Value(std::string text) : value_(std::move(text)) {}
  Value(List list) : value_(std::move(list)) {}
  Value(Object object) : value_(std::move(object)) {}

  // What it holds; null where it is of another kind.
  template <class Kind>
  const Kind* As() const {
    return std::get_if<Kind>(&value_);
  }

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Object> value_;
};

// A list of any values that become one each: names, numbers.
template <class Items>
List ListOf(const Items& items) {
  return List(items.begin(), items.end());
}

// The text of a value. `indent` spaces a level, each entry on a line of its own; 0: all on one line, without
// spaces. Numbers are the shortest that are read as the same double; one that is not finite is null. What is
// not UTF-8 in a text becomes U+FFFD, since a reader would refuse the whole.
std::string Write(const Value& value, int indent = 0);

}  // namespace kaori::json
