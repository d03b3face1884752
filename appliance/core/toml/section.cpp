#include "appliance/core/toml/section.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/toml/nearest.h"

namespace kaori::toml {
namespace {

// What a missing table reads as, so that the readers of its keys can go on.
const Value& EmptyTable() {
  static const Value empty;
  return empty;
}

}  // namespace

// The form is that of compilers, which editors find: "file:line: item: reason".
void Faults::Add(int line, std::string_view item, std::string_view reason) {
  if (IsFaulty(item)) return;
  items_.emplace_back(item);
  lines_.push_back(fmt::format("{}:{}: {}{}{}", file_, line, item, item.empty() ? "" : ": ", reason));
}

// "eye" covers "eye.radius" and "eye[2]", but not "eyes".
bool Faults::IsFaulty(std::string_view item) const {
  return std::any_of(items_.begin(), items_.end(), [item](const std::string& faulty) {
    const bool within = item.starts_with(faulty) && !faulty.empty();
    return item == faulty || (within && (item[faulty.size()] == '.' || item[faulty.size()] == '['));
  });
}

Result<void> Faults::Verdict() const {
  if (any()) return FailInput(fmt::format("{}", fmt::join(lines_, "\n")));
  return {};
}

Section::Section(const Value& table, std::string name, Faults& faults)
    : table_(&table), name_(std::move(name)), faults_(&faults) {}

// "eye.radius", as people would look for it in the file; without a key the table's own name.
std::string Section::ItemName(std::string_view key) const {
  if (key.empty()) return name_;
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

// The line of the value where it is there, else of its table.
void Section::Fault(std::string_view key, std::string_view reason) {
  const Value* value = Find(key);
  faults_->Add(value != nullptr ? value->line : table_->line, ItemName(key), reason);
}

// The one place where a value that is missing, or is of the wrong kind, becomes a fault; null means that it
// has. `what` ends the sentence "must be ...".
const Value* Section::Need(std::string_view key, Value::Kind kind, std::string_view what) {
  const Value* value = Find(key);
  if (value == nullptr) {
    Fault(key, "is missing");
    return nullptr;
  }
  if (value->kind == kind) return value;
  Fault(key, fmt::format("must be {}", what));
  return nullptr;
}

double Section::Number(std::string_view key) {
  const Value* value = Need(key, Value::Kind::kNumber, "a number");
  return value != nullptr ? value->number : 0;
}

// Written as "not within" and so true for NaN too. A key that is missing has its fault already.
double Section::Length_cm(std::string_view key, Range within_cm) {
  const double length = Number(key);
  if (Has(key) && !(length >= within_cm.low && length <= within_cm.high))
    Fault(key, fmt::format("is {}, and must lie between {} and {}: lengths are centimetres", length,
                           within_cm.low, within_cm.high));
  return length;
}

double Section::Length_cmOr(std::string_view key, double otherwise, Range within_cm) {
  return Has(key) ? Length_cm(key, within_cm) : otherwise;
}

double Section::NumberOr(std::string_view key, double otherwise) {
  return Has(key) ? Number(key) : otherwise;
}

int Section::WholeOr(std::string_view key, int otherwise, int low, int high) {
  const double value = NumberOr(key, otherwise);
  if (value == std::floor(value) && value >= low && value <= high) return static_cast<int>(value);
  Fault(key, fmt::format("is {}, and must be a whole number from {} to {}", value, low, high));
  return low;
}

float Section::FloatOr(std::string_view key, float otherwise, float low, float high, std::string_view unit) {
  const auto value = static_cast<float>(NumberOr(key, otherwise));
  if (!(value >= low && value <= high))
    Fault(key, fmt::format("is {}{}, not within {} to {}", value, unit, low, high));
  return value;
}

std::string Section::Text(std::string_view key) {
  const Value* value = Need(key, Value::Kind::kText, "a text in quotes");
  return value != nullptr ? value->text : std::string();
}

std::string Section::TextOr(std::string_view key, std::string_view otherwise) {
  return Has(key) ? Text(key) : std::string(otherwise);
}

glm::dvec3 Section::Point(std::string_view key) {
  const Value* value = Need(key, Value::Kind::kList, "three numbers");
  if (value == nullptr) return {};
  const auto point = AsPoint(*value);
  if (!point) Fault(key, "must be three numbers");
  return point.value_or(glm::dvec3(0));
}

glm::dvec3 Section::PointOr(std::string_view key, glm::dvec3 otherwise) {
  return Has(key) ? Point(key) : otherwise;
}

// A point that is missing has its fault already and reads as the origin, which is never too far.
glm::dvec3 Section::Point_cm(std::string_view key, double most_cm) {
  const glm::dvec3 point = Point(key);
  const double far = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  if (far > most_cm)
    Fault(key,
          fmt::format("lies {} from the origin, and {} is the most: lengths are centimetres", far, most_cm));
  return point;
}

// A wrong item is a fault and counts as 0, so that the list keeps its length. The same holds for Points and
// Texts.
std::vector<double> Section::Numbers(std::string_view key) {
  std::vector<double> numbers;
  const Value* value = Need(key, Value::Kind::kList, "a list of numbers");
  if (value == nullptr) return numbers;
  for (const Value& item : value->list) {
    if (item.kind != Value::Kind::kNumber) Fault(key, "must be a list of numbers");
    numbers.push_back(item.number);
  }
  return numbers;
}

std::vector<glm::dvec3> Section::Points(std::string_view key) {
  std::vector<glm::dvec3> points;
  const Value* value = Need(key, Value::Kind::kList, "a list of points");
  if (value == nullptr) return points;
  for (const Value& item : value->list) {
    const auto point = AsPoint(item);
    if (!point) Fault(key, "each of its points must be three numbers");
    points.push_back(point.value_or(glm::dvec3(0)));
  }
  return points;
}

std::vector<std::string> Section::Texts(std::string_view key) {
  std::vector<std::string> texts;
  const Value* value = Need(key, Value::Kind::kList, "a list of texts");
  if (value == nullptr) return texts;
  for (const Value& item : value->list) {
    if (item.kind != Value::Kind::kText) Fault(key, "must be a list of texts");
    texts.push_back(item.text);
  }
  return texts;
}

// A part that is missing reads as an empty table. Its keys are missing then too, but
// Faults keeps quiet about them.
Section Section::Part(std::string_view key) {
  const Value* value = Need(key, Value::Kind::kTable, "a table");
  return {value != nullptr ? *value : EmptyTable(), ItemName(key), *faults_};
}

// Parts are numbered from 1 in messages, as people count. An item that is no table reads as an empty one.
std::vector<Section> Section::Parts(std::string_view key) {
  std::vector<Section> parts;
  if (!Has(key)) return parts;
  const Value* value = Need(key, Value::Kind::kList, "tables");
  if (value == nullptr) return parts;
  for (std::size_t i = 0; i < value->list.size(); ++i) {
    if (value->list[i].kind != Value::Kind::kTable) Fault(key, "must be tables");
    parts.push_back({value->list[i], fmt::format("{}[{}]", ItemName(key), i + 1), *faults_});
  }
  return parts;
}

void Section::AllowOnly(std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : table_->table) {
    if (std::find(known.begin(), known.end(), key) == known.end())
      Fault(key, "is not known here" + DidYouMean(key, known));
  }
}

std::optional<glm::dvec3> AsPoint(const Value& value) {
  if (value.kind != Value::Kind::kList || value.list.size() != 3) return std::nullopt;
  glm::dvec3 point{};
  for (int axis = 0; axis < 3; ++axis) {
    const Value& number = value.list[static_cast<std::size_t>(axis)];
    if (number.kind != Value::Kind::kNumber) return std::nullopt;
    point[axis] = number.number;
  }
  return point;
}

}  // namespace kaori::toml
