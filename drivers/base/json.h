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
// In order; values of different kinds may stand in one list.
using List = std::vector<Value>;
// In the order in which it is written; names are not compared. A map would
// sort the entries, and a report is read by people.
using Object = std::vector<std::pair<std::string, Value>>;

// Null, a switch, a number, a text, a list or an object (RFC 8259). The constructors convert implicitly,
// so that a tree of values is written as it looks: {{"name", name}, {"rate_hz", 60}}. Numbers that are
// whole stay so: an int64 is not printed as 60.0. Values are trees by value; nothing is shared.
class Value {
 public:
  Value() = default;  // null
  Value(bool on) : value_(on) {}
  // Unsigned numbers beyond 2^63 - 1 would come out negative; nothing here counts as far.
  template <std::integral Number>
  requires(!std::same_as<Number, bool>) Value(Number number) : value_(static_cast<std::int64_t>(number)) {}
  template <std::floating_point Number>
  Value(Number number) : value_(static_cast<double>(number)) {}
  // Pointers convert to bool before they convert to a text: without
  // this constructor a literal would be a switch.
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

// The text of a value. `indent` spaces a level, each entry on a line of its own; 0: all on one line,
// without spaces. Numbers are the shortest that are read as the same double, with ".0" where they would
// look whole; one that is not finite is null, since JSON has no word for it. What is not UTF-8 in a text
// becomes U+FFFD, since a reader would refuse the whole. Calls itself once for each level. Cannot fail.
std::string Write(const Value& value, int indent = 0);

}  // namespace kaori::json
