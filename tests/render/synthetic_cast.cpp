#include "tests/render/synthetic_cast.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "tests/render/synthetic_head.h"

namespace kaori::tests {
namespace {

using face::Expression;
using face::ExpressionKind;
using face::Index;

constexpr std::size_t kNearest = 4;  // Control points that a vertex follows.

struct NamedPoint {
  const char* name;
  glm::vec2 place;
  Lip lip = Lip::kNone;
};

const std::vector<NamedPoint>& NamedPoints() {
  constexpr float kCorner = kMouthHalfWidth + 0.01F;
  static const std::vector<NamedPoint> points{{"UC", {0.5F, kMouthPlace + 0.005F}, Lip::kUpper},
                                              {"LC", {0.5F, kMouthPlace - 0.005F}, Lip::kLower},
                                              {"MC.l", {0.5F + kCorner, kMouthPlace}},
                                              {"MC.r", {0.5F - kCorner, kMouthPlace}},
                                              {"B2.l", {0.575F, 0.63F}},
                                              {"B2.r", {0.425F, 0.63F}},
                                              {"C2.l", {0.575F, 0.58F}},
                                              {"C2.r", {0.425F, 0.58F}},
                                              {"CH", {0.5F, 0.2F}},
                                              {"F1", {0.5F, 0.8F}},
                                              {"N", {0.5F, 0.5F}},
                                              {"K.l", {0.62F, 0.4F}},
                                              {"K.r", {0.38F, 0.4F}},
                                              {"T.l", {0.68F, 0.6F}},
                                              {"T.r", {0.32F, 0.6F}},
                                              {"J.l", {0.6F, 0.22F}},
                                              {"J.r", {0.4F, 0.22F}},
                                              {"U", {0.5F, 0.42F}}};
  return points;
}

// 1 in the middle of the face, falling to 0 where it ceases to move.
float Fade(glm::vec2 place) {
  const auto ramp = [](float inside) { return std::clamp(inside / 0.08F, 0.0F, 1.0F); };
  return ramp(0.3F - std::abs(place.x - 0.5F)) * ramp(place.y - 0.1F) * ramp(0.9F - place.y);
}

bool AcrossTheSlit(Lip a, Lip b) {
  return a != Lip::kNone && b != Lip::kNone && a != b;
}

// Each vertex follows its nearest control points, the nearer the more; lips follow their own side of the
// slit.
void AddRow(const HeadVertex& vertex, face::SparseRows& rows) {
  const auto& points = NamedPoints();
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto distance = [&](std::size_t i) {
    return AcrossTheSlit(points[i].lip, vertex.lip) ? 9.0F : glm::length(points[i].place - vertex.place);
  };
  std::ranges::sort(order, {}, distance);
  std::vector<float> weight;
  for (std::size_t i = 0; i < kNearest; ++i)
    weight.push_back(1 / (1e-4F + distance(order[i]) * distance(order[i])));
  const float sum = std::accumulate(weight.begin(), weight.end(), 0.0F);
  for (std::size_t i = 0; i < kNearest; ++i) {
    rows.column.push_back(static_cast<Index>(order[i]));
    rows.weight.push_back(weight[i] / sum * Fade(vertex.place));
  }
  rows.row_start.push_back(static_cast<std::uint32_t>(rows.column.size()));
}

// The vertex that lies nearest to a point in the parameter space, on its side of the slit.
Index NearestVertex(const NamedPoint& point, const std::vector<HeadVertex>& vertices) {
  const auto distance = [&](const HeadVertex& v) {
    return v.side >= 0 || AcrossTheSlit(point.lip, v.lip) ? 9.0F : glm::length(point.place - v.place);
  };
  return static_cast<Index>(std::ranges::min_element(vertices, {}, distance) - vertices.begin());
}

face::ControlNet MakeNet(const std::vector<HeadVertex>& vertices, Index moving) {
  face::ControlNet net;
  net.to_cage.row_start = {0};
  net.surface.row_start = {0};
  for (Index v = 0; v < moving; ++v) AddRow(vertices[v], net.to_cage);
  for (const NamedPoint& point : NamedPoints()) {
    net.points.push_back({point.name, point.place});
    net.surface.column.push_back(NearestVertex(point, vertices));
    net.surface.weight.push_back(1);
    net.surface.row_start.push_back(static_cast<std::uint32_t>(net.surface.column.size()));
  }
  return net;
}

struct Move {
  const char* point;
  glm::vec3 by_m;
};

Expression Express(const face::Cast& cast, const char* name, ExpressionKind kind,
                   const std::vector<Move>& moves) {
  Expression expression{.name = name, .kind = kind, .displacement = {}, .lids = {}};
  expression.displacement.resize(cast.net.points.size());
  for (const Move& move : moves) expression.displacement[PointNamed(cast, move.point)] = move.by_m;
  return expression;
}

std::vector<Expression> SixExpressions(const face::Cast& cast) {
  using enum ExpressionKind;
  std::vector<Expression> six{
      Express(cast, "neutral", kExpression, {}),
      Express(cast, "smile", kExpression,
              {{"MC.l", {0.006F, 0.006F, -0.002F}},
               {"MC.r", {-0.006F, 0.006F, -0.002F}},
               {"K.l", {0, 0.003F, 0.002F}},
               {"K.r", {0, 0.003F, 0.002F}}}),
      Express(cast, "surprised", kExpression,
              {{"B2.l", {0, 0.009F, 0}},
               {"B2.r", {0, 0.009F, 0}},
               {"LC", {0, -0.012F, -0.002F}},
               {"CH", {0, -0.01F, 0}}}),
      Express(cast, "a", kMouth, {{"LC", {0, -0.015F, 0}}, {"UC", {0, 0.001F, 0}}, {"CH", {0, -0.013F, 0}}}),
      Express(cast, "brow_up", kChannel, {{"B2.l", {0, 0.008F, 0}}, {"B2.r", {0, 0.008F, 0}}}),
      Express(cast, "wide", kMouth, {{"MC.l", {0.006F, 0, 0}}, {"MC.r", {-0.006F, 0, 0}}})};
  six[1].lids = {0.5F, 0.5F};
  return six;
}

constexpr std::array<HeadShape, 4> kShapes{{{},
                                            {.radii_m = {0.095F, 0.1F, 0.09F}},
                                            {.turn_rad = 0.5236F, .scale = 1.3F},
                                            {.radii_m = {0.07F, 0.13F, 0.16F}}}};
constexpr std::array kShapeNames{"reference", "round", "turned", "long"};

void AddFaces(int count, const std::vector<HeadVertex>& vertices, face::Cast& cast) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    cast.faces.push_back(ShapeHead(vertices, kShapes[i % kShapes.size()]));
    cast.faces.back().name = kShapeNames[i % kShapes.size()];
  }
}

void AddExpressions(int count, face::Cast& cast) {
  const auto six = SixExpressions(cast);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    cast.expressions.push_back(six[i % six.size()]);
    for (glm::vec3& d : cast.expressions.back().displacement)
      d *= 1.0F / static_cast<float>(1 + i / six.size());
  }
}

}  // namespace

face::Cast MakeSyntheticCast(const SyntheticSize& size) {
  face::Cast cast;
  const auto vertices = MakeHead(size.columns, size.rows, cast.topology);
  cast.topology.fine = HalveQuads(cast.topology);
  cast.net = MakeNet(vertices, cast.topology.moving_count);
  AddFaces(size.faces, vertices, cast);
  AddExpressions(size.expressions, cast);
  return cast;
}

std::uint16_t ExpressionNamed(const face::Cast& cast, const char* name) {
  const auto at = std::ranges::find(cast.expressions, name, &Expression::name);
  assert(at != cast.expressions.end());
  return static_cast<std::uint16_t>(at - cast.expressions.begin());
}

std::size_t PointNamed(const face::Cast& cast, const char* name) {
  const auto at = std::ranges::find(cast.net.points, name, &face::ControlPoint::name);
  assert(at != cast.net.points.end());
  return static_cast<std::size_t>(at - cast.net.points.begin());
}

}  // namespace kaori::tests
