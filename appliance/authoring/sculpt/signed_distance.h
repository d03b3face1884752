// A solid as a smooth union of a few round bodies: how far a point lies outside it, and where a ray meets it.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace kaori::sculpt {

// A round body of the solid; all lengths in centimetres, in the frame of recipe.h.
struct Body {
  enum class Shape { kEllipsoid, kCapsule, kBox };
  // Added to all bodies before it, or cut from them.
  enum class Join { kAdd, kCut };
  Shape shape = Shape::kEllipsoid;
  Join join = Join::kAdd;
  // Stands on both sides of x = 0.
  bool mirrored = false;
  // Width of the fillet between it and all bodies before it; 0: a sharp edge.
  double blend_cm = 0;
  // Ellipsoid, box: centre. Capsule: one end.
  glm::dvec3 a{};
  // Ellipsoid: the three radii. Box: half its sizes. Capsule: the other end.
  glm::dvec3 b{};
  // Capsule: the radii of its ends. Box: the first one is that of its rounded edges.
  double radius_a_cm = 0;
  double radius_b_cm = 0;
};

// Bodies are joined in their order, each added to or cut from all before it. Negative inside. Exact on the
// surface only; elsewhere good enough to walk by. Without bodies everything lies far outside.
double SignedDistance(const std::vector<Body>& bodies, glm::dvec3 p);

// Walks from p + 5 cm along `outwards` (a unit vector) back inwards to the surface: the first hit
// from outside. A ray that misses the solid ends somewhere beside it; no fault is raised, and the
// picture shows it.
glm::dvec3 Project(const std::vector<Body>& bodies, glm::dvec3 p, glm::dvec3 outwards);

}  // namespace kaori::sculpt
