#include "appliance/authoring/appearance/cloth_mesh.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

namespace kaori::appearance {
namespace {

// Below a length of 1e-7 a vector has no direction.
glm::vec3 UnitOr(glm::vec3 v, glm::vec3 otherwise) {
  const float length = glm::length(v);
  return length > 1e-7F ? v / length : otherwise;
}

// Rows end at their edges, columns wrap where the patch is closed.
std::size_t At(const Patch& p, int row, int column) {
  const int c = p.closed_across ? (column + p.columns) % p.columns : std::clamp(column, 0, p.columns - 1);
  return static_cast<std::size_t>(std::clamp(row, 0, p.rows - 1)) * static_cast<std::size_t>(p.columns) +
         static_cast<std::size_t>(c);
}

// By central differences; one-sided at the edges.
glm::vec3 Along(const Patch& p, int row, int column) {
  return p.points[At(p, row + 1, column)] - p.points[At(p, row - 1, column)];
}

// As Along; a closed patch has no edges here.
glm::vec3 Across(const Patch& p, int row, int column) {
  return p.points[At(p, row, column + 1)] - p.points[At(p, row, column - 1)];
}

}  // namespace

// Rows go down, columns to the character's left: down x left is outwards.
std::vector<glm::vec3> PatchNormals(const Patch& patch) {
  std::vector<glm::vec3> normals(patch.points.size());
  for (int row = 0; row < patch.rows; ++row) {
    for (int column = 0; column < patch.columns; ++column) {
      const glm::vec3 n = glm::cross(Along(patch, row, column), Across(patch, row, column));
      normals[At(patch, row, column)] = UnitOr(n, glm::vec3(0, 0, 1));
    }
  }
  return normals;
}

// Normals come in Finish, when all triangles are known.
face::Index ClothMesh::Append(const Patch& patch, const std::vector<glm::vec3>& points) {
  const auto first = static_cast<face::Index>(mesh_.vertices.size());
  for (int row = 0; row < patch.rows; ++row) {
    for (int column = 0; column < patch.columns; ++column) {
      face::PropVertex v;
      v.position = points[At(patch, row, column)] * kMetresPerCm;
      v.tangent = UnitOr(Along(patch, row, column), glm::vec3(0, -1, 0));
      v.along = patch.along.empty() ? 0 : patch.along[static_cast<std::size_t>(row)];
      v.across = patch.across.empty() ? 0 : patch.across[static_cast<std::size_t>(column)];
      mesh_.vertices.push_back(v);
    }
  }
  return first;
}

// Counter-clockwise as given; where a tip closes, one of the two triangles has no area and is left out.
void ClothMesh::Quad(face::Index a, face::Index b, face::Index c, face::Index d) {
  const auto apart = [this](face::Index i, face::Index j) {
    return glm::distance(mesh_.vertices[i].position, mesh_.vertices[j].position) > 1e-7F;
  };
  if (apart(a, b) && apart(b, c) && apart(a, c)) mesh_.triangles.push_back({a, b, c});
  if (apart(a, c) && apart(c, d) && apart(a, d)) mesh_.triangles.push_back({a, c, d});
}

// Rows go down and columns to the character's left, so a, b, c, d is counter-clockwise from outside.
void ClothMesh::Cells(const Patch& patch, face::Index first, bool flipped) {
  const int cells = patch.closed_across ? patch.columns : patch.columns - 1;
  for (int row = 0; row + 1 < patch.rows; ++row) {
    for (int column = 0; column < cells; ++column) {
      const auto corner = [&](int r, int c) { return first + static_cast<face::Index>(At(patch, r, c)); };
      const face::Index a = corner(row, column);
      const face::Index b = corner(row + 1, column);
      const face::Index c = corner(row + 1, column + 1);
      const face::Index d = corner(row, column + 1);
      flipped ? Quad(d, c, b, a) : Quad(a, b, c, d);
    }
  }
}

// `wall` joins two neighbouring points of the edge to their copies behind; edges are walked so that
// walls look outwards.
void ClothMesh::Rim(const Patch& patch, face::Index front, face::Index back) {
  const auto wall = [&](int r0, int c0, int r1, int c1) {
    const auto a = static_cast<face::Index>(At(patch, r0, c0));
    const auto b = static_cast<face::Index>(At(patch, r1, c1));
    Quad(front + a, back + a, back + b, front + b);
  };
  const int cells = patch.closed_across ? patch.columns : patch.columns - 1;
  for (int c = 0; c < cells; ++c) {
    wall(0, c + 1, 0, c);
    wall(patch.rows - 1, c, patch.rows - 1, c + 1);
  }
  for (int r = 0; !patch.closed_across && r + 1 < patch.rows; ++r) {
    wall(r, 0, r + 1, 0);
    wall(r + 1, patch.columns - 1, r, patch.columns - 1);
  }
}

// For cloth whose inside nobody sees, such as a body that goes out of the picture.
void ClothMesh::AddPatch(const Patch& patch) {
  Cells(patch, Append(patch, patch.points), false);
}

// The rim shares the vertices of front and back, so its edges are shaded as rounded ones.
void ClothMesh::AddSolid(const Patch& patch, const std::function<float(int, int)>& thickness_cm) {
  const std::vector<glm::vec3> normals = PatchNormals(patch);
  std::vector<glm::vec3> behind = patch.points;
  for (int row = 0; row < patch.rows; ++row) {
    for (int column = 0; column < patch.columns; ++column) {
      const std::size_t i = At(patch, row, column);
      behind[i] -= normals[i] * thickness_cm(row, column);
    }
  }
  const face::Index front = Append(patch, patch.points);
  const face::Index back = Append(patch, behind);
  Cells(patch, front, false);
  Cells(patch, back, true);
  Rim(patch, front, back);
}

// Normals are sums of the areas of the triangles about a vertex; 1e6 keeps square millimetres in metres away
// from UnitOr's bound.
face::Prop ClothMesh::Finish(std::string name, face::Part part, glm::vec3 colour) && {
  for (const face::Triangle& t : mesh_.triangles) {
    const glm::vec3 a = mesh_.vertices[t[0]].position;
    const glm::vec3 area = glm::cross(mesh_.vertices[t[1]].position - a, mesh_.vertices[t[2]].position - a);
    for (const face::Index i : t) mesh_.vertices[i].normal += area;
  }
  for (face::PropVertex& v : mesh_.vertices) v.normal = UnitOr(v.normal * 1e6F, glm::vec3(0, 0, 1));
  mesh_.name = std::move(name);
  mesh_.part = part;
  mesh_.colour = colour;
  return std::move(mesh_);
}

}  // namespace kaori::appearance
