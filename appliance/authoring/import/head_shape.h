// A head at rest with the motions by which its features are known. The same for heads of any topology.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "appliance/authoring/import/mesh_graph.h"
#include "render/face/cast.h"

namespace kaori::import {

// Dense motions: one offset for each vertex, metres, along the head's axes. An empty one is not known.
using Offsets = std::vector<glm::vec3>;

// Where the lids of one eye are, open, at the ends and in the middle of their margins. Taken from a cast's
// own lid rings (face::LidRig), or from what is seen of the ball.
struct LidMarks {
  // At the nose and at the temple, then the middles of both margins.
  glm::vec3 inner{};
  glm::vec3 outer{};
  glm::vec3 upper{};
  glm::vec3 lower{};
};

// Metres, right-handed: +Y up, +Z out of the face, +X to the character's left; origin between the eyes. All
// motions have as many offsets as there are positions, or none. Vertices that belong to no triangle (the
// teeth of an imported head) move with the motions but are no surface: neither seen nor walked along.
struct HeadShape {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  // [0] the character's left (+X), [1] the right, in this and all pairs below. Radius 0: no ball was found.
  std::array<face::EyeBall, 2> eyes{};
  // The jaw opened as far as the artist, the show or JawByForm opens it ("jaw_open").
  Offsets jaw;
  // Lids wholly shut.
  std::array<Offsets, 2> blink;
  // Brows raised wholly.
  std::array<Offsets, 2> brow_up;
  // None where the lids are told by `blink` alone.
  std::array<std::optional<LidMarks>, 2> lids{};
};

// The reference face of a cast, of which no motion is known.
HeadShape AtRest(const face::Cast& cast);
// The same with the motions that its expressions of the names jaw_open, brow_up_left and
// brow_up_right make on it, and its lids shut. A cast without one of those has no such motion. The composer
// is run once for each motion.
HeadShape ShapeOfCast(const face::Cast& cast);
// What one expression does to the reference face at weight 1, lids included. `expression` must be an
// element of cast.expressions.
Offsets OffsetsOfCast(const face::Cast& cast, const face::Expression& expression);

// Each vertex's part in a motion: the length of its offset, 0..1 of the largest one. All zero where `offsets`
// is empty or moves nothing.
std::vector<float> Shares(const Offsets& offsets, std::size_t vertices);

// A named spot by which two heads are laid over each other. Names are equal on all heads ("left eye, inner
// corner", "nose tip", "chin, below"); left and right are the character's.
struct Landmark {
  std::string name;
  glm::vec3 at{};
};

// Corners and middles of mouth and eyes, nose, chin, brows, ears, crown, back: as many as the motions that
// the head knows allow. Only what can be seen from the front, or lies on the outline, counts. Each landmark
// is a vertex, or the middle between two. Slits are searched for by comparing all vertices that move with all
// that do not, so the time grows with the square of their number.
std::vector<Landmark> FindLandmarks(const HeadShape& head);

// Where the landmark of that name is; none where the head lacks it.
std::optional<glm::vec3> LandmarkAt(const std::vector<Landmark>& marks, std::string_view name);

}  // namespace kaori::import
