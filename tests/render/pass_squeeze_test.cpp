// Where expressions press the skin together.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "render/face/composer.h"
#include "render/passes/squeeze.h"
#include "tests/render/default_cast.h"

namespace kaori {
namespace {

class SqueezeTest : public ::testing::Test {
 protected:
  SqueezeTest() : cast_(tests::DefaultCast()), composer_(cast_), squeeze_(cast_.topology) {}

  // Of the first face with this expression; all of the fine mesh.
  std::vector<glm::vec2> With(std::string_view expression, float folds = 1) {
    face::Weights weights;
    weights.faces.Push(0, 1);
    const auto rest = Cage(weights);
    const auto found = std::ranges::find(cast_.expressions, expression, &face::Expression::name);
    weights.expressions.Push(static_cast<std::uint16_t>(found - cast_.expressions.begin()), 1);
    const auto pressed = squeeze_.Between(rest, Cage(weights), folds);
    return {pressed.begin(), pressed.end()};
  }
  std::vector<glm::vec3> Cage(const face::Weights& weights) {
    const auto cage = composer_.Compose(weights, face::Detail::kCage).cage;
    return {cage.begin(), cage.end()};
  }
  // The greatest pressure within 2 cm of a control point.
  glm::vec2 Near(const std::vector<glm::vec2>& pressed, std::string_view point) const {
    const auto at = std::ranges::find(cast_.net.points, point, &face::ControlPoint::name);
    const face::SparseRows& rows = cast_.topology.fine.attributes_from_cage;
    glm::vec2 most(0);
    for (std::size_t v = 0; v < rows.rows(); ++v) {
      const glm::vec2 uv = cast_.topology.uv[rows.column[rows.row_start[v]]];
      const glm::vec2 away_m = (uv - at->uv) * glm::vec2(face::kParameterWidth_m, face::kParameterHeight_m);
      if (glm::length(away_m) < 0.02F) most = glm::max(most, pressed[v]);
    }
    return most;
  }

  const face::Cast& cast_;
  face::Composer composer_;
  passes::Squeeze squeeze_;
};

TEST_F(SqueezeTest, IsNoneAtRest) {
  for (const glm::vec2& pressed : With("neutral")) EXPECT_EQ(pressed, glm::vec2(0));
}

TEST_F(SqueezeTest, OfRaisedBrowsFoldsTheForeheadAlongItsWidth) {
  const glm::vec2 forehead = Near(With("surprised"), "F1");
  EXPECT_GT(forehead.y, 0.10F);
  EXPECT_GT(forehead.y, 1.5F * forehead.x);
}

TEST_F(SqueezeTest, OfAFrownFoldsTheSkinBetweenTheBrowsUpright) {
  EXPECT_GT(Near(With("angry"), "G").x, 0.05F);
}

TEST_F(SqueezeTest, IsAsMuchAsTheFacesFoldsSay) {
  EXPECT_FLOAT_EQ(Near(With("surprised", 0.5F), "F1").y, 0.5F * Near(With("surprised"), "F1").y);
  for (const glm::vec2& pressed : With("surprised", 0)) EXPECT_EQ(pressed, glm::vec2(0));
}

TEST_F(SqueezeTest, IsNoneOnLidsThatShut) {
  face::Weights open;
  open.faces.Push(0, 1);
  face::Weights shut = open;
  shut.lids_shut = {1, 1};
  const auto rest = Cage(open);
  const auto pressed = squeeze_.Between(rest, Cage(shut), 1);
  const face::SparseRows& rows = cast_.topology.fine.attributes_from_cage;
  for (std::size_t v = 0; v < rows.rows(); ++v) {
    if (rows.row_start[v + 1] != rows.row_start[v] + 1) continue;
    for (const face::LidRig& lids : cast_.topology.lids) {
      const bool is_lid = std::ranges::count(lids.upper, rows.column[rows.row_start[v]]) > 0;
      if (is_lid) {
        EXPECT_EQ(pressed[v], glm::vec2(0));
      }
    }
  }
}

}  // namespace
}  // namespace kaori
