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

// Where a vertex of one head lies on another: a point of a triangle of the other head.
struct Spot {
  // Vertices of the other head. Three times the same one where no triangle about the nearest vertex comes
  // nearer than the vertex itself.
  std::array<Index, 3> corners{};
  // Barycentric: each 0..1, sum 1, in the order of `corners`.
  glm::vec3 shares{};
  // From the vertex, warped onto the other head, to that point. Bridge::Carry fades motion out by it, since a
  // spot that is far off says little (the inside of a nose that the other head has not).
  float distance_m = 0;

  // Of one value for each vertex of the other head, what lies here: linear within the triangle.
  template <class T>
  T Of(const std::vector<T>& values) const {
    return shares.x * values[corners[0]] + shares.y * values[corners[1]] + shares.z * values[corners[2]];
  }
};

// The correspondence of two heads, computed once and then used for every shape that is carried. It goes one
// way, from `from` to `to`; the way back is another Bridge. Immutable after Between and holding copies of all
// it needs, so both heads may go away.
//
// This is expression cloning (Noh and Neumann, 2001) with the correspondence found from landmarks: a
// biharmonic warp by them first, then the nearest point of the surface.
class Bridge {
 public:
  // None where the heads have fewer than eight landmarks in common, or all of them lie in one plane, since no
  // warp is then determined. Landmarks of `from` that `to` lacks are appended to `missing` by name, also
  // where a bridge comes about.
  //
  // Spots are found by place and, so that nothing crosses a slit, by how jaw and lids move there: the lower
  // lip is laid on the lower lip, though the upper one touches it. Each vertex of `to` is compared with each
  // vertex of `from`, so the time grows with the product of both counts.
  static std::optional<Bridge> Between(const HeadShape& from, const HeadShape& to,
                                       std::vector<std::string>& missing);

  // A shape of `from`, as it looks on `to`: each spot's motion is led through the warp, which turns and
  // scales it, then smoothed along the surface. From 1 cm off its spot on, a motion fades; from 3 cm on there
  // is none. Takes one offset for each vertex of `from`, answers one for each vertex of `to`; metres, in the
  // axes of either head.
  Offsets Carry(const Offsets& from) const;

  // One number of each vertex, mixed by the shares alone: neither faded nor smoothed.
  std::vector<float> Carry(const std::vector<float>& from) const;

  // By vertex of `to`.
  const std::vector<Spot>& spots() const { return spots_; }
  // How many landmarks the heads have in common.
  std::size_t landmarks() const { return landmarks_; }

 private:
  // Spots are found afterwards.
  Bridge(std::vector<glm::vec3> from, sculpt::Warp forth, MeshGraph surface)
      : from_(std::move(from)), forth_(std::move(forth)), surface_(std::move(surface)) {}

  // Rest positions of `from`, metres.
  std::vector<glm::vec3> from_;
  // From the space of `from` to the space of `to`.
  sculpt::Warp forth_;
  // The surface of `to`, along which carried motion is smoothed.
  MeshGraph surface_;
  std::vector<Spot> spots_;
  std::size_t landmarks_ = 0;
};

}  // namespace kaori::import
