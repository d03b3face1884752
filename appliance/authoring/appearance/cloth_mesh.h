// A mesh under construction on the cutting table, in centimetres; done, it becomes a prop in metres.
//
// Used for hair, clothes, gear and teeth alike: all of them are grids of points, single-sided or with a back.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::appearance {

// Of what looks say, in what a cast says.
inline constexpr float kMetresPerCm = 0.01F;

// A grid of points: rows run along a lock or down a garment, columns across, counter-clockwise seen from
// outside when rows go down and columns go to the character's left. Row-major; rows * columns points.
struct Patch {
  // Two at least of each.
  int rows = 0;
  int columns = 0;
  bool closed_across = false;  // The last column joins the first.
  std::vector<glm::vec3> points;
  // Per row, 0..1 from root to tip; empty: 0. PropVertex::along of hair.
  std::vector<float> along;
  // Per column; its fraction stripes a lock. Empty: 0.
  std::vector<float> across;
};

// Grows by patches until Finish; not thread-safe. Points are not shared between patches.
class ClothMesh {
 public:
  // Adds one side of a patch as it is; its back is culled.
  void AddPatch(const Patch& patch);

  // Adds a patch as a solid: its face, a back `thickness_cm(row, column)` behind it along the normals, and
  // the rim between.
  void AddSolid(const Patch& patch, const std::function<float(int, int)>& thickness_cm);

  // Hands out the prop: positions in metres, smooth unit normals, tangents along the rows, shade 1. Triangles
  // without area were left out.
  face::Prop Finish(std::string name, face::Part part, glm::vec3 colour) &&;

 private:
  // Adds the vertices of a patch, with these points instead of its own; the first one's number.
  face::Index Append(const Patch& patch, const std::vector<glm::vec3>& points);
  // Two triangles, but those that have two corners in one place.
  void Quad(face::Index a, face::Index b, face::Index c, face::Index d);
  // Triangles between the points of a patch whose vertices begin at `first`; `flipped` turns them over.
  void Cells(const Patch& patch, face::Index first, bool flipped);
  // Walls between a face and its back along the open edges.
  void Rim(const Patch& patch, face::Index front, face::Index back);

  face::Prop mesh_;
};

// Normals of a grid, pointing out of its face; unit, also where the grid collapses to a point (+Z there).
std::vector<glm::vec3> PatchNormals(const Patch& patch);

}  // namespace kaori::appearance
