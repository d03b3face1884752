// The list that a check writes to, and the questions that several checks ask.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/face/topology.h"

namespace kaori::face {

// Collects lines while a cast is checked; for one thread. Items are named as people know them:
// "face \"dog\", occlusion".
class Faults {
 public:
  // A line that is ready.
  void Add(std::string fault) { lines_.push_back(std::move(fault)); }
  // All lines, in the order in which they were found; the list is empty afterwards.
  std::vector<std::string> Release() { return std::move(lines_); }

  // Each adds a line that begins with `item` where the thing is not as it has to be, and answers whether it
  // is. Later checks ask the answer, so that none looks beyond the end of what an earlier one refused.
  // `has` must be `wanted`.
  bool Size(const std::string& item, std::size_t has, std::size_t wanted);
  // Each must be below `limit`. Checked even where sizes are wrong.
  bool Indices(const std::string& item, std::span<const Index> indices, std::size_t limit);
  // No value may be infinite or no number.
  bool Finite(const std::string& item, std::span<const float> values);
  bool Finite(const std::string& item, std::span<const glm::vec2> values);
  bool Finite(const std::string& item, std::span<const glm::vec3> values);
  // Rows in order, columns below `columns`, weights finite.
  bool Rows(const std::string& item, const SparseRows& rows, std::size_t wanted_rows, std::size_t columns);

 private:
  std::vector<std::string> lines_;
};

inline bool IsFinite(const glm::vec2& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}
inline bool IsFinite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The parts of FindFaults; see check.h. Everything that stands in a Topology: sizes, indices, unfolding,
// twins, lids and the fine mesh.
void CheckTopology(const Topology& topology, Faults& faults);

}  // namespace kaori::face
