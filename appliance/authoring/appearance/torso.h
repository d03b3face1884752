// The body under the clothes: where a face's neck ends and where its shoulders lie. Centimetres.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::appearance {

// A neck as an oval cone: measured on the face, so that collars fit it.
struct Neck {
  // The axis from under the chin down to the shoulders.
  glm::vec3 top_cm{0, -12.5F, -3};
  glm::vec3 bottom_cm{0, -17, -3.8F};
  glm::vec2 top_radii_cm{3.5F, 3.5F};  // Sideways, forwards.
  glm::vec2 bottom_radii_cm{3.7F, 3.7F};

  // The point `off_cm` off the skin at a height, `around_deg` from the front. Heights beyond top and bottom
  // go on the cone.
  glm::vec3 At(float around_deg, float y_cm, float off_cm) const;
};
// By two slices of the lowest rows of the cast's mesh, whose vertices the face has; what a face without a neck there gets is the usual one.
Neck MeasureNeck(const face::Face& face);

// A body as a smooth union of capsules and ellipsoids, by a few measures; only its surface is asked for.
struct Torso {
  Neck neck;
  float shoulders_cm = 13;  // The joints' distance from the middle.
  float drop_cm = 17.8F;    // The joints' distance below the eyes.
  float chest_cm = 0;       // How far a bosom stands out.
  float wrinkles_cm = 0.2F;

  // The surface seen from the middle of the chest: `around_deg` from the front, `elevation_deg` up; `off_cm`
  // above it. Folds of cloth are added below the collar. Traced along a ray: some 60 evaluations.
  glm::vec3 At(float around_deg, float elevation_deg, float off_cm) const;

  // The point; where it lies less than `off_cm` above the surface, seen from there, the place so far above it.
  glm::vec3 Above(glm::vec3 point_cm, float off_cm) const;

  // The elevation at which the surface, going up, reaches the height; between 10 and 85 degrees.
  float ElevationAt(float around_deg, float y_cm) const;

  // The elevation of a point as At() counts it.
  static float ElevationOf(glm::vec3 point_cm);

 private:
  // Signed distance to the skin, cm; negative inside.
  float Distance(glm::vec3 point_cm) const;
};

}  // namespace kaori::appearance
