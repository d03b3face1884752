// The synthetic cast's surface: which vertices there are, how they are joined, and where a shape puts them.
#pragma once

#include <cstdint>
#include <vector>

#include "render/face/cast.h"

namespace kaori::tests {

enum class Lip : std::uint8_t { kNone, kUpper, kLower };

// A vertex of the grid, or of a lid (side 0 or 1; `ring` and `angle` say where).
struct HeadVertex {
  glm::vec2 place{};
  Lip lip = Lip::kNone;
  int side = -1;
  int ring = 0;
  float along = 0;  // 0 at the inner corner of the eye .. 1 at the outer.
  float above = 0;  // 1 upper lid, -1 lower lid.
};

struct HeadShape {
  glm::vec3 radii_m{0.075F, 0.11F, 0.095F};
  float turn_rad = 0;
  float scale = 1;
};

inline constexpr float kMouthPlace = 0.32F;      // v of the slit,
inline constexpr float kMouthHalfWidth = 0.06F;  // and how far it goes in u.

// Fills everything of the topology but the fine mesh, and lists its vertices.
std::vector<HeadVertex> MakeHead(int columns, int rows, face::Topology& topology);

// One step of plain halving of every quad (`quads`: two triangles each, in the topology's order).
face::FineMesh HalveQuads(const face::Topology& topology);

face::Face ShapeHead(const std::vector<HeadVertex>& vertices, const HeadShape& shape);

}  // namespace kaori::tests
