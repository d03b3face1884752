// The skull that hair grows on, and the paths that hair takes over it. Centimetres; directions start at its
// centre, 0 degrees is straight ahead, +90 the character's left.
#pragma once

#include <glm/vec3.hpp>

namespace kaori::appearance {

// An ellipsoid.
struct Skull {
  glm::vec3 centre_cm{0, 3, -0.9F};
  glm::vec3 radii_cm{7.35F, 8.1F, 8.9F};

  // The point `offset_cm` above the skull in a direction, which need not be a unit.
  glm::vec3 Above(glm::vec3 direction, float offset_cm) const;
};

// A unit vector; +90 degrees round is the character's left, elevation is up.
glm::vec3 Direction(float around_deg, float elevation_deg);

// Along the great circle from one unit direction to another; t 0..1. They must not be opposite.
glm::vec3 GreatCircle(glm::vec3 from, glm::vec3 to, float t);

// Hair that falls from the crown over the widest part of the skull and hangs from there.
struct Fall {
  // The height of the ends.
  float end_y_cm = -8;
  // Above the skull, once clear of the crown.
  float offset_cm = 0.4F;
  // Out, halfway down what hangs; a part of the radius.
  float flare = 0.035F;
  // In, at the ends; a part of the radius.
  float curl = 0.2F;
  // Elevation, seen from straight ahead, where it leaves a parting in the middle; 0: it falls from the crown.
  float parting_deg = 0;
};
// The part of a fall that lies on the skull, by t; from here on it hangs.
inline constexpr float kHangsFrom = 0.5F;
// A point of the hair that hangs in this direction: t 0 at its root, 0.5 at the widest part of the skull, 1
// at its end.
glm::vec3 OnFall(const Skull& skull, const Fall& fall, float around_deg, float t);

// Hair that falls from the crown over the forehead and ends there, at a height.
struct Fringe {
  // The height of the ends, and how far above the skull it lies.
  float end_y_cm = 3.2F;
  float offset_cm = 0.4F;
  float sweep_deg = 0;  // The ends lie this much further round.
};
// The same for a fringe: t 0 at the root .. 1 at the end.
glm::vec3 OnFringe(const Skull& skull, const Fringe& fringe, float around_deg, float t);

// Hair combed from a hairline over the top to the back, by three unit directions.
struct Comb {
  // Where it starts, what it passes towards, and where it ends.
  glm::vec3 from{0, 0, 1};
  glm::vec3 over{0, 1, 0};
  glm::vec3 to{0, 0, -1};
  // Above the skull at the hairline, at the highest (`lift_cm`), and where it ends (`end_cm`).
  float root_cm = 0.05F;
  float lift_cm = 0.6F;
  float end_cm = 0.2F;
};
// The same for combed hair.
glm::vec3 OnComb(const Skull& skull, const Comb& comb, float t);

// Outwards from the head at a point of its hair: away from the skull above its middle, sideways below.
// A unit vector.
glm::vec3 OutwardsAt(const Skull& skull, glm::vec3 point_cm);

}  // namespace kaori::appearance
