// A head at rest with the motions by which its features are known. The same for heads of any topology.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "appliance/authoring/import/mesh_graph.h"
#include "appliance/authoring/import/model.h"
#include "render/face/cast.h"

namespace kaori::import {

// Dense motions: one offset for each vertex, metres. An empty one is not known.
using Offsets = std::vector<glm::vec3>;

// Where the lids of one eye are, where a cast says it (face::LidRig).
struct LidMarks {
  glm::vec3 inner{};
  glm::vec3 outer{};
  glm::vec3 upper{};
  glm::vec3 lower{};
};

struct HeadShape {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  std::array<face::EyeBall, 2> eyes{};  // [0] the character's left (+X).
  Offsets jaw;                          // jaw_open.
  std::array<Offsets, 2> blink;         // Lids wholly shut.
  std::array<Offsets, 2> brow_up;
  std::array<std::optional<LidMarks>, 2> lids{};
};

// The reference face of a cast, and its expressions as they look on it: `name` by name, lids included.
HeadShape ShapeOfCast(const face::Cast& cast);
Offsets OffsetsOfCast(const face::Cast& cast, const face::Expression& expression);

// Each vertex's part in a motion, 0..1 of the largest.
std::vector<float> Shares(const Offsets& offsets, std::size_t vertices);

// A named spot by which two heads are laid over each other.
struct Landmark {
  std::string name;
  glm::vec3 at{};
};

// Corners and middles of mouth and eyes, nose, chin, brows, ears, crown, back: as many as the motions that
// the head knows allow. Only what can be seen from the front, or lies on the outline, counts.
std::vector<Landmark> FindLandmarks(const HeadShape& head);

}  // namespace kaori::import
