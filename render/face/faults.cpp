#include "render/face/faults.h"

#include <algorithm>

#include <fmt/format.h>

namespace kaori::face {
namespace {

// One line for all that are wrong, with their number and where the first stands.
template <class Range, class Wrong>
bool NoneIs(Faults& faults, const std::string& item, const Range& range, Wrong wrong, const char* reason) {
  const auto count = std::ranges::count_if(range, wrong);
  if (count == 0) return true;
  const auto first = std::ranges::find_if(range, wrong) - range.begin();
  faults.Add(fmt::format("{}: {} {}, the first is number {}", item, count, reason, first));
  return false;
}

}  // namespace

bool Faults::Size(const std::string& item, std::size_t has, std::size_t wanted) {
  if (has == wanted) return true;
  Add(fmt::format("{}: has {} entries and needs {}", item, has, wanted));
  return false;
}

bool Faults::Indices(const std::string& item, std::span<const Index> indices, std::size_t limit) {
  return NoneIs(
      *this, item, indices, [&](Index i) { return i >= limit; }, "indices out of range");
}

bool Faults::Finite(const std::string& item, std::span<const float> values) {
  return NoneIs(
      *this, item, values, [](float v) { return !std::isfinite(v); }, "values are not numbers");
}

bool Faults::Finite(const std::string& item, std::span<const glm::vec2> values) {
  return NoneIs(
      *this, item, values, [](const glm::vec2& v) { return !IsFinite(v); }, "coordinates are not numbers");
}

bool Faults::Finite(const std::string& item, std::span<const glm::vec3> values) {
  return NoneIs(
      *this, item, values, [](const glm::vec3& v) { return !IsFinite(v); }, "positions are not numbers");
}

// Each test stands on the one before: starts of rows are looked at only where there are as many as wanted. A
// pack from a disk may hold anything, and ApplyToValues checks nothing.
bool Faults::Rows(const std::string& item, const SparseRows& rows, std::size_t wanted_rows,
                  std::size_t columns) {
  if (!Size(item + ", rows", rows.rows(), wanted_rows)) return false;
  if (!Size(item + ", weights", rows.weight.size(), rows.column.size())) return false;
  if (rows.row_start.empty()) return true;
  // Rows that overlap or run beyond the entries would read foreign memory in every frame.
  const bool in_order = rows.row_start.front() == 0 && std::ranges::is_sorted(rows.row_start) &&
                        rows.row_start.back() == rows.column.size();
  if (!in_order) Add(item + ": rows overlap, or do not end where their entries end");
  return Indices(item, rows.column, columns) && Finite(item, rows.weight) && in_order;
}

}  // namespace kaori::face
