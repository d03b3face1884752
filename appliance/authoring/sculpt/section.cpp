#include "appliance/authoring/sculpt/section.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace kaori::sculpt {
namespace {

const Value& EmptyTable() {
  static const Value empty;
  return empty;
}

bool IsGridVertex(const Key& key) {
  const bool end_of_crown = key.b == kRows && (key.a == 0 || key.a == kColumns);
  const auto inside = [&key](const Block& b, int column0) {
    return key.a > column0 && key.a < b.column1 && key.b > b.row0 && key.b < b.row1;
  };
  return key.a >= 0 && key.a <= kColumns && key.b >= 0 && key.b <= kRows && !end_of_crown &&
         !inside(kEyeBlock, kEyeBlock.column0) && !inside(kEarBlock, kEarBlock.column0) &&
         !inside(kMouthBlock, -1);
}

bool IsOnRings(const Key& key, int rim, int rings) {
  return key.a >= 0 && key.a < rim && key.b >= 0 && key.b <= rings;
}

}  // namespace

void Faults::Add(int line, std::string_view item, std::string_view reason) {
  if (IsFaulty(item)) return;
  items_.emplace_back(item);
  lines_ += fmt::format("{}{}:{}: {}: {}", lines_.empty() ? "" : "\n", file_, line, item, reason);
}

bool Faults::IsFaulty(std::string_view item) const {
  return std::any_of(items_.begin(), items_.end(), [item](const std::string& faulty) {
    const bool within = item.starts_with(faulty) && !faulty.empty();
    return item == faulty || (within && (item[faulty.size()] == '.' || item[faulty.size()] == '['));
  });
}

Result<void> Faults::Verdict() const {
  if (any()) return FailInput(lines_);
  return {};
}

Section::Section(const Value& table, std::string name, Faults& faults)
    : table_(&table), name_(std::move(name)), faults_(&faults) {}

const Value* Section::Find(std::string_view key) const {
  const auto found = std::find_if(table_->table.begin(), table_->table.end(),
                                  [key](const auto& entry) { return entry.first == key; });
  return found == table_->table.end() ? nullptr : &found->second;
}

std::string Section::ItemName(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

void Section::Fault(std::string_view key, std::string_view reason) {
  const Value* value = Find(key);
  faults_->Add(value != nullptr ? value->line : table_->line, ItemName(key), reason);
}

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

double Section::NumberOr(std::string_view key, double otherwise) {
  return Has(key) ? Number(key) : otherwise;
}

std::string Section::Word(std::string_view key) {
  const Value* value = Need(key, Value::Kind::kWord, "a word in quotes");
  return value != nullptr ? value->word : std::string();
}

std::string Section::WordOr(std::string_view key, std::string_view otherwise) {
  return Has(key) ? Word(key) : std::string(otherwise);
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

std::vector<std::string> Section::Words(std::string_view key) {
  std::vector<std::string> words;
  const Value* value = Need(key, Value::Kind::kList, "a list of words");
  if (value == nullptr) return words;
  for (const Value& item : value->list) {
    if (item.kind != Value::Kind::kWord) Fault(key, "must be a list of words");
    words.push_back(item.word);
  }
  return words;
}

Section Section::Part(std::string_view key) {
  const Value* value = Need(key, Value::Kind::kTable, "a table");
  return {value != nullptr ? *value : EmptyTable(), ItemName(key), *faults_};
}

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
    if (std::find(known.begin(), known.end(), key) == known.end()) Fault(key, "is not known here");
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

std::optional<Key> AsVertex(std::string_view word) {
  std::istringstream words{std::string(word)};
  std::string region;
  Key key;
  std::string rest;
  if (!(words >> region >> key.a >> key.b) || (words >> rest)) return std::nullopt;
  if (region == "grid" && IsGridVertex(key)) return key;
  if (region == "eye" && IsOnRings(key, kEyeRim, kEyeRings)) return Key{Region::kEye, key.a, key.b};
  if (region == "mouth" && IsOnRings(key, kMouthRim, kMouthRings)) return Key{Region::kMouth, key.a, key.b};
  return std::nullopt;
}

}  // namespace kaori::sculpt
