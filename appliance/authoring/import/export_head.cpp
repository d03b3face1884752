#include "appliance/authoring/import/export_head.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "appliance/authoring/import/fine_mesh.h"
#include "appliance/authoring/sculpt/modelled.h"

namespace kaori::import {
namespace {

// Enough for a ball that looks round beside the skin, in fields; the poles lie before and behind.
constexpr int kAroundBall = 24;
constexpr int kAlongBall = 12;

// Text of an OBJ file, grown line by line and given away at the end. Positions and texture coordinates are numbered by themselves, from 1 on.
class ObjText {
 public:
  explicit ObjText(std::string head) : text_(std::move(head)) {}

  void BeginObject(std::string_view name) { Add("o {}\n", name); }
  int Position(const glm::vec3& p) {
    Add("v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
    return ++positions_;
  }
  int Uv(const glm::vec2& uv) {
    Add("vt {:.6f} {:.6f}\n", uv.x, uv.y);
    return ++uvs_;
  }
  // Pairs of position and uv, counter-clockwise seen from outside.
  void Polygon(const std::vector<std::pair<int, int>>& corners) {
    text_ += "f";
    for (const auto& [position, uv] : corners) Add(" {}/{}", position, uv);
    text_ += "\n";
  }

  std::string Release() { return std::move(text_); }

 private:
  template <class... Values>
  void Add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  std::string text_;
  int positions_ = 0;
  int uvs_ = 0;
};

// One position for both sides of a seam, so that a tool which moves it does not tear the head open.
void WriteSkin(const face::Topology& topology, const face::Face& face, ObjText& text) {
  text.BeginObject(face.name);
  // By vertex of the cage: the numbers that the file gives its position and its texture coordinates.
  std::vector<int> position(topology.vertex_count);
  std::vector<int> uv;
  for (Index v = 0; v < topology.vertex_count; ++v) {
    const Index first = std::min(v, topology.twin[v]);
    position[v] = first == v ? text.Position(face.positions[v]) : position[first];
    uv.push_back(text.Uv(topology.texture[v]));
  }
  // Diagonals of quads are no wires: what the artist gets are the quads.
  std::set<std::pair<Index, Index>> wires;
  for (const auto& [a, b] : topology.wires) wires.insert(std::minmax(a, b));
  const auto weld = [&](Index v) { return std::min(v, topology.twin[v]); };
  const auto is_wire = [&](Index a, Index b) { return wires.contains(std::minmax(weld(a), weld(b))); };
  for (const mesh::Polygon& polygon : PolygonsOf(topology.triangles, is_wire)) {
    std::vector<std::pair<int, int>> corners;
    for (const Index v : polygon) corners.emplace_back(position[v], uv[v]);
    text.Polygon(corners);
  }
}

// Rows run from the pole in front to the one behind, columns round it. A pole has a uv for each column, as
// every corner wants one.
void WriteBall(const face::EyeBall& ball, std::size_t side, ObjText& text) {
  text.BeginObject(side == 0 ? "eye_left" : "eye_right");
  const auto uv_of = [&](int row, int column) {
    return glm::vec2(sculpt::kEyeTile[side] + 0.1F + 0.8F * static_cast<float>(column) / kAroundBall,
                     0.1F + 0.8F * static_cast<float>(row) / kAlongBall);
  };
  // By row and column; the last column's positions are those of the first, its uv are not.
  std::vector<std::vector<int>> positions;
  std::vector<std::vector<int>> uvs;
  for (int row = 0; row <= kAlongBall; ++row) {
    const float down = glm::radians(180.0F * static_cast<float>(row) / kAlongBall);
    positions.emplace_back();
    uvs.emplace_back();
    for (int column = 0; column <= kAroundBall; ++column) {
      const float round = glm::radians(360.0F * static_cast<float>(column) / kAroundBall);
      const glm::vec3 way(std::sin(down) * std::cos(round), std::sin(down) * std::sin(round), std::cos(down));
      const bool is_new = column == 0 || (row > 0 && row < kAlongBall && column < kAroundBall);
      positions.back().push_back(is_new ? text.Position(ball.centre + ball.radius_m * way)
                                        : positions.back().front());
      uvs.back().push_back(text.Uv(uv_of(row, column)));
    }
  }
  for (std::size_t row = 0; row < kAlongBall; ++row)
    for (std::size_t column = 0; column < kAroundBall; ++column) {
      const auto corner = [&](std::size_t r, std::size_t c) { return std::pair(positions[r][c], uvs[r][c]); };
      std::vector corners{corner(row, column), corner(row + 1, column), corner(row + 1, column + 1),
                          corner(row, column + 1)};
      // At the poles two corners are one.
      if (row == 0) corners.pop_back();
      if (row + 1 == kAlongBall) corners.erase(corners.begin() + 1);
      text.Polygon(corners);
    }
}

}  // namespace

// The first lines tell whoever opens the file in an editor what may be changed.
std::string ObjOfFace(const face::Cast& cast, std::size_t face) {
  const face::Face& head = cast.faces[face];
  ObjText text(fmt::format(
      "# The face \"{}\". Move vertices as you like; leave mesh and UV map alone, by which the cast knows "
      "them.\n"
      "# Metres. The eyeballs come back with the head: move and scale them, and let them be balls.\n",
      head.name));
  WriteSkin(cast.topology, head, text);
  for (std::size_t side = 0; side < 2; ++side)
    if (head.eyes[side].radius_m > 0) WriteBall(head.eyes[side], side, text);
  return text.Release();
}

}  // namespace kaori::import
