// Reads values out of a file that people write, and remembers everything that is wrong with it, so that all
// of it is said at once: "faces/dog.toml:12: eye.radius: is missing".
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "appliance/core/toml/value.h"
#include "drivers/base/result.h"

namespace kaori::toml {

// The faults of one file, in the order in which they were found.
class Faults {
 public:
  explicit Faults(std::string file) : file_(std::move(file)) {}

  // An item has one fault, and so has all that lies within it: what follows from the first is not said.
  void Add(int line, std::string_view item, std::string_view reason);
  // Whether anything is wrong so far.
  bool any() const { return !items_.empty(); }
  const std::string& file() const { return file_; }
  const std::vector<std::string>& lines() const { return lines_; }  // "file:line: item: reason", each.
  // All lines in one error. Errors: invalid_argument where there is any fault.
  Result<void> Verdict() const;

 private:
  bool IsFaulty(std::string_view item) const;

  std::string file_;
  std::vector<std::string> items_;
  std::vector<std::string> lines_;
};

// What a number may be, both ends included.
struct Range {
  double low = 0;
  double high = 0;
};

// One table of a file. Borrows the value and the faults, which must outlive it. What is missing or of the
// wrong kind becomes a fault and reads as zero, so that a reader can go straight on and ask for the verdict
// once, at its end.
class Section {
 public:
  // `name` is how faults call the table: "eye", "scene \"night\""; empty for the file itself.
  Section(const Value& table, std::string name, Faults& faults);

  // Each reads the value of one key. The plain form wants it: a key that is missing, or of another kind, is a
  // fault and reads as 0, "" or an empty list. The form with Or takes `otherwise` where the key is missing;
  // one of the wrong kind is a fault all the same.
  double Number(std::string_view key);
  double NumberOr(std::string_view key, double otherwise);
  // A whole number within both ends; anything else is a fault and reads as `low`. An `otherwise` that lies
  // outside makes the key one that must be there.
  int WholeOr(std::string_view key, int otherwise, int low, int high);
  // A number within both ends, as float; it is given even where it is a fault. `otherwise` is judged as well.
  // `unit` follows the number in the fault: " s".
  float FloatOr(std::string_view key, float otherwise, float low, float high, std::string_view unit = "");
  // Centimetres. A fault outside of `within_cm` says so, since the usual cause is metres or millimetres.
  double Length_cm(std::string_view key, Range within_cm);
  double Length_cmOr(std::string_view key, double otherwise, Range within_cm);
  std::string Text(std::string_view key);
  std::string TextOr(std::string_view key, std::string_view otherwise);
  glm::dvec3 Point(std::string_view key);
  glm::dvec3 PointOr(std::string_view key, glm::dvec3 otherwise);
  // A point of a head: no part of it farther than `most_cm` from the origin along any axis.
  glm::dvec3 Point_cm(std::string_view key, double most_cm);
  std::vector<double> Numbers(std::string_view key);
  std::vector<glm::dvec3> Points(std::string_view key);
  std::vector<std::string> Texts(std::string_view key);
  Section Part(std::string_view key);
  std::vector<Section> Parts(std::string_view key);  // Tables written [[key]]; none is no fault.

  // Whether the key is there, of whatever kind.
  bool Has(std::string_view key) const { return Find(key) != nullptr; }
  // The value itself, for what is read by hand; null is no fault.
  const Value* Find(std::string_view key) const { return toml::Find(*table_, key); }
  const Value& table() const { return *table_; }

  // Every key must be one of `known`: a typing error must not pass silently. The fault names the nearest
  // known key where one is near.
  void AllowOnly(std::initializer_list<std::string_view> known);
  // Adds a fault of the caller's own, as "is 40, and must ..."; an empty key stands for the table itself.
  void Fault(std::string_view key, std::string_view reason);

 private:
  const Value* Need(std::string_view key, Value::Kind kind, std::string_view what);
  std::string ItemName(std::string_view key) const;

  const Value* table_;
  std::string name_;
  Faults* faults_;
};

// Three numbers in a list; none where it is anything else.
std::optional<glm::dvec3> AsPoint(const Value& value);

}  // namespace kaori::toml
