// Reads values out of a file that people write, and remembers everything that is wrong with it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "appliance/authoring/sculpt/half_topology.h"
#include "appliance/authoring/sculpt/value.h"
#include "drivers/base/result.h"

namespace kaori::sculpt {

// The faults of a file: "faces/dog.toml:12: eye.radius: is missing".
class Faults {
 public:
  explicit Faults(std::string file) : file_(std::move(file)) {}

  // An item has one fault, and so has all that lies within it: what follows from the first is not said.
  void Add(int line, std::string_view item, std::string_view reason);
  bool any() const { return !items_.empty(); }
  Result<void> Verdict() const;  // All of them, one a line.

 private:
  bool IsFaulty(std::string_view item) const;

  std::string file_;
  std::vector<std::string> items_;
  std::string lines_;
};

// One table of a file. Borrows the value and the faults. What is missing or of the wrong kind becomes a fault
// and reads as zero, so that a reader can go straight on and ask for the verdict once, at its end.
class Section {
 public:
  Section(const Value& table, std::string name, Faults& faults);

  double Number(std::string_view key);
  double NumberOr(std::string_view key, double otherwise);
  std::string Word(std::string_view key);
  std::string WordOr(std::string_view key, std::string_view otherwise);
  glm::dvec3 Point(std::string_view key);
  glm::dvec3 PointOr(std::string_view key, glm::dvec3 otherwise);
  std::vector<double> Numbers(std::string_view key);
  std::vector<glm::dvec3> Points(std::string_view key);
  std::vector<std::string> Words(std::string_view key);
  Section Part(std::string_view key);
  std::vector<Section> Parts(std::string_view key);  // Tables written [[key]]; none is no fault.

  bool Has(std::string_view key) const { return Find(key) != nullptr; }
  // The value itself, for what is read by hand; null is no fault.
  const Value* Find(std::string_view key) const;
  const Value& table() const { return *table_; }

  // Every key must be one of `known`: a typing error must not pass silently.
  void AllowOnly(std::initializer_list<std::string_view> known);
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

// The name of a vertex, as files write it: "grid 3 17", "eye 7 5", "mouth 8 6". None where it names no
// vertex.
std::optional<Key> AsVertex(std::string_view word);

}  // namespace kaori::sculpt
