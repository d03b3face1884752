#include "tests/render/synthetic_head.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

namespace kaori::tests {
namespace {

using face::Index;

constexpr int kLidColumns = 15;
constexpr int kLidRings = 7;
constexpr int kMarginRing = 4;
constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kEyeApart = 0.075F;  // |u - 0.5| of an eye's middle; its v is 0.52.
constexpr float kEyeHeight = 0.52F;
constexpr float kEyeRadius_m = 0.022F;
constexpr float kLidThickness_m = 0.0013F;
constexpr glm::vec2 kHole{0.058F,
                          0.075F};  // Half axes of the grid's hole under the lids, in the parameter space.

float EyePlace(int side) {
  return 0.5F + (side == 0 ? kEyeApart : -kEyeApart);
}

glm::vec3 OnHead(glm::vec2 place, const glm::vec3& radii_m) {
  const float longitude = (place.x - 0.5F) * 2 * kPi;
  const float latitude = (place.y - 0.5F) * 0.9F * kPi;
  return radii_m * glm::vec3{std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                             std::cos(longitude) * std::cos(latitude)};
}

bool Moves(const HeadVertex& v) {
  return v.side >= 0 || (std::abs(v.place.x - 0.5F) < 0.3F && v.place.y > 0.1F && v.place.y < 0.9F);
}

bool InHole(glm::vec2 place) {
  const auto inside = [&](int side) {
    return glm::length((place - glm::vec2{EyePlace(side), kEyeHeight}) / kHole) < 1;
  };
  return inside(0) || inside(1);
}

// The vertices of the grid and the lids with their quads, before the moving ones are put first.
class Sketch {
 public:
  Sketch(int columns, int rows) : columns_(columns), rows_(rows) {
    const int mouth_row = static_cast<int>(std::lround(kMouthPlace * static_cast<float>(rows)));
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) AddCell(c, r, mouth_row);
    }
    AddLids(0);
    AddLids(1);
  }

  std::vector<HeadVertex> vertices;
  std::vector<std::array<Index, 4>> quads;
  std::array<face::LidRig, 2> lids;

 private:
  Index GridVertex(int c, int r, Lip lip) {
    const auto key = std::array{c, r, static_cast<int>(lip)};
    const auto [at, fresh] = numbers_.try_emplace(key, static_cast<Index>(vertices.size()));
    if (fresh) {
      HeadVertex vertex;
      vertex.place = {static_cast<float>(c) / static_cast<float>(columns_),
                      static_cast<float>(r) / static_cast<float>(rows_)};
      vertex.lip = lip;
      vertices.push_back(vertex);
    }
    return at->second;
  }

  // The slit: vertices of its row inside the mouth are there twice.
  Lip LipOf(int c, int r, int mouth_row, Lip half) const {
    const float u = static_cast<float>(c) / static_cast<float>(columns_);
    return r == mouth_row && std::abs(u - 0.5F) < kMouthHalfWidth ? half : Lip::kNone;
  }

  void AddCell(int c, int r, int mouth_row) {
    const glm::vec2 middle{(static_cast<float>(c) + 0.5F) / static_cast<float>(columns_),
                           (static_cast<float>(r) + 0.5F) / static_cast<float>(rows_)};
    if (InHole(middle)) return;
    const Lip half = r < mouth_row ? Lip::kLower : Lip::kUpper;
    const auto corner = [&](int i, int j) { return GridVertex(i, j, LipOf(i, j, mouth_row, half)); };
    quads.push_back({corner(c, r), corner(c + 1, r), corner(c + 1, r + 1), corner(c, r + 1)});
  }

  Index LidVertex(int side, int ring, int column, float above) {
    HeadVertex vertex;
    vertex.side = side;
    vertex.ring = ring;
    vertex.along = static_cast<float>(column) / (kLidColumns - 1);
    vertex.above = above;
    // Rings shrink towards the eye; the margin and what lies behind it are a lens.
    const float size = 1.2F - 0.11F * static_cast<float>(ring);
    const float outwards = side == 0 ? 1.0F : -1.0F;
    vertex.place = {EyePlace(side) - outwards * 0.05F * size * std::cos(kPi * vertex.along),
                    kEyeHeight + above * 0.045F * size * std::sin(kPi * vertex.along)};
    vertices.push_back(vertex);
    return static_cast<Index>(vertices.size() - 1);
  }

  void AddLids(int side) {
    face::LidRig& rig = lids[static_cast<std::size_t>(side)];
    rig = {.columns = kLidColumns,
           .rings = kLidRings,
           .margin_ring = kMarginRing,
           .upper = {},
           .lower = {},
           .follow_upper = {0.08F, 0.28F, 0.56F, 0.86F, 1, 1, 1},
           .follow_lower = {0.05F, 0.17F, 0.34F, 0.86F, 1, 1, 1}};
    for (int ring = 0; ring < kLidRings; ++ring) {
      for (int j = 0; j < kLidColumns; ++j) rig.upper.push_back(LidVertex(side, ring, j, 1));
      for (int j = 0; j < kLidColumns; ++j) {
        const bool corner = j == 0 || j == kLidColumns - 1;
        rig.lower.push_back(corner ? rig.upper[LidAt(ring, j)] : LidVertex(side, ring, j, -1));
      }
    }
    JoinLids(side, rig);
  }

  static std::size_t LidAt(int ring, int column) {
    return static_cast<std::size_t>(ring) * kLidColumns + static_cast<std::size_t>(column);
  }

  // Counter-clockwise from outside: the character's left eye runs to the viewer's right.
  void JoinLids(int side, const face::LidRig& rig) {
    for (int ring = 0; ring + 1 < kLidRings; ++ring) {
      for (int j = 0; j + 1 < kLidColumns; ++j) {
        const auto quad = [&](const std::vector<Index>& lid, bool flip) {
          std::array<Index, 4> q{lid[LidAt(ring + 1, j)], lid[LidAt(ring + 1, j + 1)],
                                 lid[LidAt(ring, j + 1)], lid[LidAt(ring, j)]};
          if (flip) std::ranges::reverse(q);
          quads.push_back(q);
        };
        quad(rig.upper, side == 1);
        quad(rig.lower, side == 0);
      }
    }
  }

  int columns_;
  int rows_;
  std::map<std::array<int, 3>, Index> numbers_;
};

std::vector<Index> NumbersWithMovingFirst(const std::vector<HeadVertex>& vertices, Index& moving) {
  std::vector<Index> number(vertices.size());
  Index next = 0;
  for (const bool wanted : {true, false}) {
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (Moves(vertices[v]) == wanted) number[v] = next++;
    }
    if (wanted) moving = next;
  }
  return number;
}

// Both edges of the seam lie at the same height: u = 0 and u = 1.
std::vector<Index> SeamTwins(const std::vector<HeadVertex>& vertices) {
  std::vector<Index> twin(vertices.size());
  std::map<float, Index> left;
  for (Index v = 0; v < twin.size(); ++v) {
    twin[v] = v;
    if (vertices[v].place.x == 0) left[vertices[v].place.y] = v;
  }
  for (Index v = 0; v < twin.size(); ++v) {
    if (vertices[v].place.x != 1) continue;
    twin[v] = left.at(vertices[v].place.y);
    twin[twin[v]] = v;
  }
  return twin;
}

float MouthShare(const HeadVertex& v) {
  const glm::vec2 from = v.place - glm::vec2{0.5F, kMouthPlace};
  return v.side >= 0 ? 0.0F : std::clamp(1.6F * std::exp(-glm::dot(from, from) / 0.008F) - 0.3F, 0.0F, 1.0F);
}

void AddQuad(const std::array<Index, 4>& q, face::Topology& topology) {
  topology.triangles.push_back({q[0], q[1], q[2]});
  topology.triangles.push_back({q[0], q[2], q[3]});
  for (std::size_t i = 0; i < 4; ++i) topology.wires.push_back({q[i], q[(i + 1) % 4]});
}

// On the sphere of that radius about the eye, straight ahead of the vertex's place on the head.
glm::vec3 OnBall(const glm::vec3& on_head, const glm::vec3& centre, float radius_m) {
  const glm::vec2 from{on_head.x - centre.x, on_head.y - centre.y};
  const float depth = std::sqrt(std::max(radius_m * radius_m - glm::dot(from, from), 1e-6F));
  return {on_head.x, on_head.y, centre.z + depth};
}

glm::vec3 EyeCentre(int side, const glm::vec3& radii_m) {
  return OnHead({EyePlace(side), kEyeHeight}, radii_m) - glm::vec3{0, 0, 0.8F * kEyeRadius_m};
}

glm::vec3 Position(const HeadVertex& v, const glm::vec3& radii_m) {
  const glm::vec3 on_head = OnHead(v.place, radii_m);
  if (v.side < 0) return on_head;
  const glm::vec3 centre = EyeCentre(v.side, radii_m);
  if (v.ring > kMarginRing) {
    const float sunk_m = v.ring == kMarginRing + 1 ? 0.0002F : -0.003F;
    return OnBall(on_head, centre, kEyeRadius_m + sunk_m);
  }
  const float over_m = v.ring == kMarginRing ? 0.0F : 0.05F * kEyeRadius_m;
  const glm::vec3 lid = OnBall(on_head, centre, kEyeRadius_m + kLidThickness_m + over_m);
  return lid.z > on_head.z || v.ring == kMarginRing ? lid : on_head;
}

}  // namespace

std::vector<HeadVertex> MakeHead(int columns, int rows, face::Topology& topology) {
  Sketch sketch(columns, rows);
  const auto number = NumbersWithMovingFirst(sketch.vertices, topology.moving_count);
  std::vector<HeadVertex> vertices(number.size());
  for (std::size_t v = 0; v < number.size(); ++v) vertices[number[v]] = sketch.vertices[v];
  for (auto& quad : sketch.quads) {
    for (Index& corner : quad) corner = number[corner];
    AddQuad(quad, topology);
  }
  for (face::LidRig& rig : sketch.lids) {
    for (Index& v : rig.upper) v = number[v];
    for (Index& v : rig.lower) v = number[v];
  }
  topology.vertex_count = static_cast<Index>(vertices.size());
  topology.lids = sketch.lids;
  topology.twin = SeamTwins(vertices);
  for (const HeadVertex& v : vertices) {
    topology.uv.push_back(v.place);
    topology.texture.push_back(v.place);
    topology.mouth_share.push_back(MouthShare(v));
  }
  return vertices;
}

face::Face ShapeHead(const std::vector<HeadVertex>& vertices, const HeadShape& shape) {
  const float s = std::sin(shape.turn_rad);
  const float c = std::cos(shape.turn_rad);
  const auto turned = [&](const glm::vec3& p) {
    return shape.scale * glm::vec3{c * p.x + s * p.z, p.y, c * p.z - s * p.x};
  };
  face::Face face;
  for (const HeadVertex& v : vertices) face.positions.push_back(turned(Position(v, shape.radii_m)));
  face.occlusion.assign(vertices.size(), 1.0F);
  for (int side = 0; side < 2; ++side) {
    face.eyes[static_cast<std::size_t>(side)] = {.centre = turned(EyeCentre(side, shape.radii_m)),
                                                 .radius_m = shape.scale * kEyeRadius_m,
                                                 .lid_thickness_m = shape.scale * kLidThickness_m};
  }
  face.eye_look = {
      .iris = {0.1F, 0.05F, 0.02F}, .iris_radius_m = 0.013F, .lash_length_m = 0.004F, .lash_wing_m = 0.004F};
  return face;
}

}  // namespace kaori::tests
