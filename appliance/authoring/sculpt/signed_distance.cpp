#include "appliance/authoring/sculpt/signed_distance.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kaori::sculpt {
namespace {

// Rounds |x| off at 0, as sqrt(x^2 + 0.25^2), so that mirrored bodies leave no crease there.
constexpr double kSoftMiddle_cm = 0.25;
// Project begins this far outside the aimed point: before any nose or chin that a table may have
// aimed too deep.
constexpr double kStart_cm = 5;
// Sixty steps of 0.8 bring the rest of the way below rounding; a loop with a tolerance would stop at
// different places for neighbours.
constexpr int kSteps = 60;
// Of the distance: blended ellipsoids overstate it a little, and a full step could pass through a thin lip.
constexpr double kStride = 0.8;

// I. Quilez's cubic smooth minimum. It leaves both bodies as they are where they differ by more than `width`,
// so that a fillet reaches no farther than it says; a width of 0 is a sharp edge.
double SmoothMin(double a, double b, double width) {
  if (width <= 0) return std::min(a, b);
  const double h = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - h * h * h * width / 6;
}

// The bound of I. Quilez (Ellipsoid SDF, iquilezles.org): |p/r| (|p/r| - 1) / |p/r^2|. Zero and of the right
// slope on the surface; away from it too small or too large by up to the ratio of the radii, which is why
// Project takes shorter steps.
double ToEllipsoid(const Body& body, glm::dvec3 p) {
  const glm::dvec3 q = p - body.a;
  const double k0 = glm::length(q / body.b);
  const double k1 = glm::length(q / (body.b * body.b));
  return k0 * (k0 - 1) / std::max(k1, 1e-9);
}

// A round cone without the tangent correction: the radius is mixed along the axis by where the foot of p
// lies. Exact for equal radii.
double ToCapsule(const Body& body, glm::dvec3 p) {
  const glm::dvec3 axis = body.b - body.a;
  const glm::dvec3 q = p - body.a;
  const double h = std::clamp(glm::dot(q, axis) / glm::dot(axis, axis), 0.0, 1.0);
  return glm::length(q - h * axis) - (body.radius_a_cm + (body.radius_b_cm - body.radius_a_cm) * h);
}

// The exact distance to a box whose edges are rounded by radius_a_cm, which is taken off its halves first.
double ToBox(const Body& body, glm::dvec3 p) {
  const glm::dvec3 q = glm::abs(p - body.a) - (body.b - body.radius_a_cm);
  const double inside = std::min(std::max({q.x, q.y, q.z}), 0.0);
  return glm::length(glm::max(q, glm::dvec3(0))) + inside - body.radius_a_cm;
}

// `folded` is p with its x folded over to the left side.
double ToBody(const Body& body, glm::dvec3 p, glm::dvec3 folded) {
  const glm::dvec3 q = body.mirrored ? folded : p;
  switch (body.shape) {
    case Body::Shape::kEllipsoid:
      return ToEllipsoid(body, q);
    case Body::Shape::kCapsule:
      return ToCapsule(body, q);
    case Body::Shape::kBox:
      break;
  }
  return ToBox(body, q);
}

}  // namespace

double SignedDistance(const std::vector<Body>& bodies, glm::dvec3 p) {
  const glm::dvec3 folded(std::sqrt(p.x * p.x + kSoftMiddle_cm * kSoftMiddle_cm), p.y, p.z);
  // Nothing at first; the first body then is the solid, since the others are added to or cut from it. A cut
  // is the minimum of insides, negated.
  double distance = 1e9;
  for (const Body& body : bodies) {
    const double to_body = ToBody(body, p, folded);
    distance = body.join == Body::Join::kAdd ? SmoothMin(distance, to_body, body.blend_cm)
                                             : -SmoothMin(-distance, to_body, body.blend_cm);
  }
  return distance;
}

// Sphere tracing (J. C. Hart 1996) with a fixed number of steps: no vertex may depend on when a loop gave up.
// Where the ray misses the solid the point ends somewhere beside it.
glm::dvec3 Project(const std::vector<Body>& bodies, glm::dvec3 p, glm::dvec3 outwards) {
  glm::dvec3 q = p + kStart_cm * outwards;
  for (int i = 0; i < kSteps; ++i) q -= kStride * SignedDistance(bodies, q) * outwards;
  return q;
}

}  // namespace kaori::sculpt
