// A mesh under construction on the cutting table, in centimetres; done, it becomes a prop in metres.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::appearance {

// A grid of points: rows run along a lock or down a garment, columns across, counter-clockwise seen from
// outside when rows go down and columns go to the character's left. Row-major.
struct Patch {
  int rows = 0;
  int columns = 0;
  bool closed_across = false;  // The last column joins the first.
  std::vector<glm::vec3> points;
  std::vector<float> along;   // Per row, 0..1.
  std::vector<float> across;  // Per column, 0..1.
};

// Grows by patches until Finish; not thread-safe. Points are not shared between patches.
class ClothMesh {
 public:
  // Adds one side of a patch as it is.
  void AddPatch(const Patch& patch);

  // Adds a patch as a solid: its face, a back `thickness_cm(row, column)` behind it, and the rim between.
  void AddSolid(const Patch& patch, const std::function<float(int, int)>& thickness_cm);

  int triangle_count() const { return static_cast<int>(mesh_.triangles.size()); }

  // Hands out the prop: positions in metres, smooth unit normals, tangents along the rows.
  face::Prop Finish(std::string name, face::Part part, glm::vec3 colour) &&;

 private:
  face::Index Append(const Patch& patch, const std::vector<glm::vec3>& points);
  void Quad(face::Index a, face::Index b, face::Index c, face::Index d);
  void Cells(const Patch& patch, face::Index first, bool flipped);
  void Rim(const Patch& patch, face::Index front, face::Index back);

  face::Prop mesh_;
};

// Normals of a grid, pointing out of its face; unit, also where the grid collapses to a point.
std::vector<glm::vec3> PatchNormals(const Patch& patch);

}  // namespace kaori::appearance
