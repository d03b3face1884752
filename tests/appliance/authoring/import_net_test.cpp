#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "appliance/authoring/import/point_choice.h"
#include "appliance/authoring/import/shape_fit.h"
#include "appliance/authoring/import/surface_net.h"
#include "appliance/authoring/mesh/subdivide.h"
#include "tests/appliance/authoring/import_glb.h"

namespace kaori::import {
namespace {

using model::Model;
using model::Plate;

constexpr int kCells = 24;

// A plate that moves everywhere, with twenty points.
struct Fitted {
  explicit Fitted(const Model& model, std::size_t points = 24)
      : plate(model), graph(plate.positions, plate.triangles) {
    HeadShape head;
    head.positions = plate.positions;
    head.triangles = plate.triangles;
    choice = ChoosePoints(graph, head, std::vector<float>(plate.positions.size(), 0.01F), {points, 0});
    surface = MakeSurfaceNet(graph, plate.positions, plate.triangles, choice);
    net.to_cage = surface;
    net.surface.row_start.push_back(0);
    for (const ChosenPoint& point : choice.points) {
      net.points.push_back({point.name, plate.uv[point.vertex]});
      net.surface.column.push_back(point.vertex);
      net.surface.weight.push_back(1);
      net.surface.row_start.push_back(static_cast<std::uint32_t>(net.surface.column.size()));
    }
  }

  Model plate;
  MeshGraph graph;
  PointChoice choice;
  face::SparseRows surface;
  face::ControlNet net;
};

float SumOf(const face::SparseRows& rows, std::size_t row) {
  return std::accumulate(rows.weight.begin() + rows.row_start[row],
                         rows.weight.begin() + rows.row_start[row + 1], 0.0F);
}

TEST(MeshGraph, MakesOneOfVerticesAtOnePlace) {
  const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_THAT(Weld(positions), ::testing::ElementsAre(0, 1, 0, 0));
  EXPECT_THAT(mesh::Twins(Weld(positions)), ::testing::ElementsAre(2, 1, 0, 3));
}

TEST(MeshGraph, GoesRoundASlit) {
  const Model plate = Plate(kCells, true);
  const MeshGraph graph(plate.positions, plate.triangles);
  EXPECT_EQ(graph.pieces(), 1U);
  MeshGraph::Nearest nearest(graph.vertices());
  const auto below = static_cast<Index>(kCells / 2 * (kCells + 1));    // Left end of the slit, lower lip,
  const auto above = static_cast<Index>((kCells + 1) * (kCells + 1));  // and the upper lip 0.01 mm beside it.
  graph.Spread(below, 0, nearest);
  EXPECT_NEAR(nearest.distance_m[above], 0.1F, 0.002F);
}

TEST(PointChoice, SpreadsPointsAndTakesNoneTwice) {
  const Fitted fitted(Plate(kCells, false));
  ASSERT_EQ(fitted.choice.points.size(), 24U);
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto a = fitted.plate.positions[fitted.choice.points[i].vertex];
      const auto b = fitted.plate.positions[fitted.choice.points[j].vertex];
      EXPECT_GT(glm::length(a - b), 0.012F);
    }
}

TEST(SurfaceNet, SharesEachVertexOutWholly) {
  const Fitted fitted(Plate(kCells, false));
  for (std::size_t row = 0; row < fitted.plate.positions.size(); ++row) {
    EXPECT_NEAR(SumOf(fitted.surface, row), 1, 2e-3);
  }
}

TEST(SurfaceNet, NeverReachesAcrossASlit) {
  const Fitted fitted(Plate(kCells, true), 60);
  const face::SparseRows& rows = fitted.surface;
  const auto& p = fitted.plate.positions;
  int looked = 0;
  for (std::size_t v = 0; v < p.size(); ++v) {
    const bool near_slit = p[v].x < 0.03F && std::abs(p[v].y - 0.05F) < 0.004F;
    if (!near_slit) continue;
    const bool above = p[v].y > 0.050005F;
    for (auto i = rows.row_start[v]; i < rows.row_start[v + 1]; ++i) {
      const glm::vec3& point = p[fitted.choice.points[rows.column[i]].vertex];
      EXPECT_EQ(point.y > 0.050005F, above) << "vertex " << v;
      ++looked;
    }
  }
  EXPECT_GT(looked, 20);
}

TEST(ShapeFit, OpensASlitExactlyAndSaysWhatPointsMiss) {
  const Fitted fitted(Plate(kCells, true), 60);
  const ShapeFit fit(fitted.net, fitted.plate.positions);
  Offsets open;
  for (const glm::vec3& p : fitted.plate.positions) {
    const float depth = std::max(0.0F, 0.05F - p.x) / 0.05F;
    open.emplace_back(0, p.y < 0.050005F ? -0.02F * depth : 0, 0);
  }
  FitError error;
  const face::Expression expression = fit.Fit("open", face::ExpressionKind::kChannel, open, error);
  EXPECT_LT(error.rms_mm, 1.0F);
  EXPECT_GT(error.rms_mm, 0.0F);
  EXPECT_NEAR(error.shape_mm, 20, 0.1);
  // Points and residual together are the artist's shape, to the rounding of floats.
  face::Cast cast;
  const auto frames = face::FitFrames(fitted.net, face::PointsOnFace(fitted.net, fitted.plate.positions));
  const auto moved = face::Carry(expression, frames, 1);
  for (std::size_t v = 0; v < open.size(); ++v) {
    glm::vec3 sum = expression.residual.empty() ? glm::vec3(0) : expression.residual[v];
    const face::SparseRows& rows = fitted.net.to_cage;
    for (auto i = rows.row_start[v]; i < rows.row_start[v + 1]; ++i)
      sum += rows.weight[i] * moved[rows.column[i]];
    EXPECT_LT(glm::length(sum - open[v]), 2e-6F);
  }
}

TEST(ShapeFit, MissesLessWithMorePoints) {
  float before = 1e9F;
  for (const std::size_t points : {12U, 30U, 90U}) {
    const Fitted fitted(Plate(kCells, false), points);
    Offsets wave;
    for (const glm::vec3& p : fitted.plate.positions)
      wave.emplace_back(0, 0, 0.01F * std::sin(60 * p.x) * std::cos(50 * p.y));
    FitError error;
    ShapeFit(fitted.net, fitted.plate.positions).Fit("wave", face::ExpressionKind::kChannel, wave, error);
    EXPECT_LT(error.rms_mm, 0.7F * before) << points;
    before = error.rms_mm;
  }
}

}  // namespace
}  // namespace kaori::import
