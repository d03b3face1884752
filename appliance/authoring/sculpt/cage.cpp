#include "appliance/authoring/sculpt/cage.h"

#include <algorithm>

namespace kaori::sculpt {
namespace {

// Expressions reach from below the chin to the forehead and to before the ear; the rest of the head is still.
// These columns and rows hold 1632 of the vertices, and only those are computed in a frame.
constexpr int kMovingColumns = 16;
constexpr int kMovingRow0 = 3;
constexpr int kMovingRow1 = 33;

// Eyes and mouth always; of the grid the front up to the ear.
bool CanMove(const Key& key) {
  if (key.region == Region::kEye || key.region == Region::kMouth) return true;
  return key.region == Region::kGrid && key.a <= kMovingColumns && key.b >= kMovingRow0 &&
         key.b <= kMovingRow1;
}

// On the plane of symmetry in front; the crown's row is there too, but is a seam, and kept twice.
bool IsMiddle(const Key& key) {
  if (key.region == Region::kGrid) return key.a == 0 && key.b < kRows;
  return key.region == Region::kMouth && (key.a == 0 || key.a == kMouthRim - 1);
}

// Left and right meet here with one position and two uv: u is 21 and -21 at the back.
bool IsSeam(const Key& key) {
  return key.region == Region::kGrid && (key.a == kColumns || key.b == kRows);
}

// A vertex is its own twin until LinkTwins has found another.
void AddVertex(Cage& cage, Index half, int side) {
  const auto vertex = static_cast<Index>(cage.vertices.size());
  cage.vertices.push_back({.half = half, .side = side, .twin = vertex});
  (side > 0 ? cage.left : cage.right)[half] = vertex;
}

// All moving, or all still vertices: left, then right. The middle is added once.
void AddVertices(Cage& cage, bool moving) {
  for (int side : {1, -1}) {
    for (Index half = 0; half < cage.half.keys.size(); ++half) {
      const Key& key = cage.half.keys[half];
      if (CanMove(key) != moving) continue;
      if (side < 0 && IsMiddle(key)) {
        cage.right[half] = cage.left[half];
      } else {
        AddVertex(cage, half, side);
      }
    }
  }
}

// Both vertices of a seam name each other. On the left and on the right they have the same uv in the half.
void LinkTwins(Cage& cage) {
  for (Index half = 0; half < cage.half.keys.size(); ++half) {
    if (!IsSeam(cage.half.keys[half])) continue;
    cage.vertices[cage.left[half]].twin = cage.right[half];
    cage.vertices[cage.right[half]].twin = cage.left[half];
  }
}

void AddQuads(Cage& cage) {
  for (const Quad& q : cage.half.quads) {
    // As wound in the half.
    cage.quads.push_back({cage.left[q[0]], cage.left[q[1]], cage.left[q[2]], cage.left[q[3]]});
  }
  for (const Quad& q : cage.half.quads) {
    // A mirror image turns a quad over, so its corners go round the other way.
    cage.quads.push_back({cage.right[q[0]], cage.right[q[3]], cage.right[q[2]], cage.right[q[1]]});
  }
}

void AddOnce(std::vector<Index>& list, Index vertex) {
  if (std::find(list.begin(), list.end(), vertex) == list.end()) list.push_back(vertex);
}

}  // namespace

// Moving vertices of both sides, then still ones of both sides.
Cage BuildCage() {
  Cage cage;
  cage.half = BuildHalfTopology();
  cage.left.resize(cage.half.keys.size());
  cage.right.resize(cage.half.keys.size());
  AddVertices(cage, true);
  cage.moving_count = static_cast<Index>(cage.vertices.size());
  AddVertices(cage, false);
  LinkTwins(cage);
  AddQuads(cage);
  return cage;
}

// The right half is the mirror image of the left one to the last bit: its x has the other sign and nothing
// else.
std::vector<glm::dvec3> WholePositions(const Cage& cage, const std::vector<glm::dvec3>& half) {
  std::vector<glm::dvec3> whole;
  whole.reserve(cage.vertices.size());
  for (const CageVertex& v : cage.vertices) whole.push_back(half[v.half] * glm::dvec3(v.side, 1, 1));
  return whole;
}

// Mirrored in u alone, so that a seam has u = 21 on one side and -21 on the other.
std::vector<glm::dvec2> WholeUvs(const Cage& cage, const std::vector<glm::dvec2>& half) {
  std::vector<glm::dvec2> whole;
  whole.reserve(cage.vertices.size());
  for (const CageVertex& v : cage.vertices) whole.push_back(half[v.half] * glm::dvec2(v.side, 1));
  return whole;
}

// By the quads' edges, each once, in the order of the quads.
std::vector<std::vector<Index>> Neighbours(const Cage& cage) {
  std::vector<std::vector<Index>> neighbours(cage.vertices.size());
  for (const Quad& quad : cage.quads) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Index a = cage.Weld(quad[i]);
      const Index b = cage.Weld(quad[(i + 1) % 4]);
      if (a == b) continue;
      AddOnce(neighbours[a], b);
      AddOnce(neighbours[b], a);
    }
  }
  return neighbours;
}

}  // namespace kaori::sculpt
