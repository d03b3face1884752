// A solid as a smooth union of a few round bodies: how far a point lies outside it, and where a ray meets it.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace kaori::sculpt {

// All lengths in centimetres.
struct Body {
  enum class Shape { kEllipsoid, kCapsule, kBox };
  enum class Join { kAdd, kCut };
  Shape shape = Shape::kEllipsoid;
  Join join = Join::kAdd;
  bool mirrored = false;   // Stands on both sides of x = 0.
  double blend_cm = 0;     // Width of the fillet between it and all bodies before it.
  glm::dvec3 a{};          // Ellipsoid, box: centre. Capsule: one end.
  glm::dvec3 b{};          // Ellipsoid: the three radii. Box: half its sizes. Capsule: the other end.
  double radius_a_cm = 0;  // Capsule: its ends. Box: of its rounded edges.
  double radius_b_cm = 0;
};

// Bodies are joined in their order. Negative inside. Exact on the surface only; elsewhere good enough to walk
// by.
double SignedDistance(const std::vector<Body>& bodies, glm::dvec3 p);

// Walks from p + 5 cm along `outwards` (a unit vector) back inwards to the surface: the first hit from
// outside.
glm::dvec3 Project(const std::vector<Body>& bodies, glm::dvec3 p, glm::dvec3 outwards);

}  // namespace kaori::sculpt
