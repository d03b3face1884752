// Carries shapes from one head to another of any topology: the heads are laid over each other by their
// landmarks.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/sculpt/warp.h"

namespace kaori::import {

// Where a vertex of one head lies on the other: a triangle and the shares of its corners.
struct Spot {
  std::array<Index, 3> corners{};
  glm::vec3 shares{};
  float distance_m = 0;  // How far the warped vertex is from it.
};

class Bridge {
 public:
  // None where the heads have fewer than eight landmarks in common, or all in one plane. `missing` then tells
  // which. Spots are found by place and, so that nothing crosses a slit, by how jaw and lids move there: the
  // lower lip is laid on the lower lip, though the upper one touches it.
  static std::optional<Bridge> Between(const HeadShape& from, const HeadShape& to,
                                       std::vector<std::string>& missing);

  // A shape of `from`, as it looks on `to`: each spot's motion is led through the warp, which turns and
  // scales it, then smoothed along the surface. Far from any spot it fades.
  Offsets Carry(const Offsets& from) const;

  // One number of each vertex.
  std::vector<float> Carry(const std::vector<float>& from) const;

  const std::vector<Spot>& spots() const { return spots_; }
  std::size_t landmarks() const { return landmarks_; }

 private:
  Bridge(std::vector<glm::vec3> from, sculpt::Warp forth, MeshGraph surface)
      : from_(std::move(from)), forth_(std::move(forth)), surface_(std::move(surface)) {}

  std::vector<glm::vec3> from_;
  sculpt::Warp forth_;
  MeshGraph surface_;  // Of `to`.
  std::vector<Spot> spots_;
  std::size_t landmarks_ = 0;
};

}  // namespace kaori::import
