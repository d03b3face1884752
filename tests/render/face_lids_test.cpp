// Lids: they shut on every face, in every expression, and never lie in the eyeball.
#include "render/face/eyelids.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/face/composer.h"
#include "tests/render/default_cast.h"
#include "tests/render/eyeball_visibility.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

using face::Cast;
using face::Composer;
using face::Detail;
using face::LidRig;
using face::Shape;
using face::Weights;

constexpr float kShut_m = 1e-5F;

Weights Wearing(std::size_t face, std::size_t expression, float shut) {
  Weights w;
  w.faces.Push(static_cast<std::uint16_t>(face), 1);
  w.expressions.Push(static_cast<std::uint16_t>(expression), 1);
  w.lids_shut = {shut, shut};
  return w;
}

std::size_t At(const LidRig& rig, int ring, int column) {
  return static_cast<std::size_t>(ring) * static_cast<std::size_t>(rig.columns) +
         static_cast<std::size_t>(column);
}

// The widest gap between the margins, metres.
float Gap_m(const LidRig& rig, std::span<const glm::vec3> cage) {
  float widest = 0;
  for (int j = 0; j < rig.columns; ++j) {
    const std::size_t i = At(rig, rig.margin_ring, j);
    widest = std::max(widest, glm::distance(cage[rig.upper[i]], cage[rig.lower[i]]));
  }
  return widest;
}

// How deep the margin and the skin around it lie in the ball, metres.
float Depth_m(const LidRig& rig, const face::EyeBall& ball, std::span<const glm::vec3> cage) {
  float deepest = 0;
  for (std::size_t i = 0; i < At(rig, rig.margin_ring + 1, 0); ++i) {
    for (const face::Index v : {rig.upper[i], rig.lower[i]}) {
      deepest = std::max(deepest, ball.radius_m - glm::distance(cage[v], ball.centre));
    }
  }
  return deepest;
}

void ExpectLidsToShut(const Cast& cast) {
  Composer composer(cast);
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    for (std::size_t j = 0; j < cast.expressions.size(); ++j) {
      const Shape& shape = composer.Compose(Wearing(i, j, 1), Detail::kCage);
      for (std::size_t side = 0; side < 2; ++side) {
        EXPECT_LE(Gap_m(cast.topology.lids[side], shape.cage), kShut_m)
            << cast.faces[i].name << ", " << cast.expressions[j].name;
      }
    }
  }
}

void ExpectLidsToStayOutOfTheBall(const Cast& cast) {
  Composer composer(cast);
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    for (std::size_t j = 0; j < cast.expressions.size(); ++j) {
      for (const float shut : {0.0F, 0.3F, 0.5F, 0.8F, 1.0F}) {
        const Shape& shape = composer.Compose(Wearing(i, j, shut), Detail::kCage);
        EXPECT_LE(Depth_m(cast.topology.lids[0], shape.eyes[0], shape.cage), 0)
            << cast.faces[i].name << ", " << cast.expressions[j].name << ", shut " << shut;
      }
    }
  }
}

TEST(Lids, ShutOnEveryFaceInEveryExpression) {
  ExpectLidsToShut(MakeSyntheticCast());
}

TEST(Lids, StayOutOfTheBallAtEveryStageOfABlink) {
  ExpectLidsToStayOutOfTheBall(MakeSyntheticCast());
}

TEST(Lids, ShutOnEveryFaceOfTheDefaultCast) {
  ExpectLidsToShut(DefaultCast());
  ExpectLidsToStayOutOfTheBall(DefaultCast());
}

// What counts in the end: from nine sides, nothing of the ball is seen past shut lids, smoothed or not.
void ExpectNothingOfTheBallSeen(const Cast& cast) {
  Composer composer(cast);
  const auto& topology = cast.topology;
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    const Shape& shape = composer.Compose(Wearing(i, 0, 1), Detail::kFine);
    for (const float yaw_rad : {-0.5F, 0.0F, 0.5F}) {
      for (const float pitch_rad : {-0.3F, 0.0F, 0.3F}) {
        const ViewAngle angle{yaw_rad, pitch_rad};
        EXPECT_EQ(BallSeen_m2(shape.eyes[0], {shape.fine, topology.fine.triangles}, angle), 0)
            << cast.faces[i].name << " from " << yaw_rad << ", " << pitch_rad;
        EXPECT_EQ(BallSeen_m2(shape.eyes[1], {shape.cage, topology.triangles}, angle), 0)
            << cast.faces[i].name << " from " << yaw_rad << ", " << pitch_rad;
      }
    }
    const Shape& open = composer.Compose(Wearing(i, 0, 0), Detail::kFine);
    EXPECT_GT(BallSeen_m2(open.eyes[0], {open.fine, topology.fine.triangles}, {}), 2e-4F)
        << cast.faces[i].name;
  }
}

TEST(Lids, HideTheBallOfEveryFaceOfTheDefaultCast) {
  ExpectNothingOfTheBallSeen(DefaultCast());
}

TEST(Lids, ShutBetweenTwoFaces) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  Weights w = Wearing(0, 0, 1);
  w.faces.clear();
  w.faces.Push(1, 0.5F);
  w.faces.Push(3, 0.5F);
  const Shape& shape = composer.Compose(w, Detail::kCage);
  EXPECT_LE(Gap_m(cast.topology.lids[0], shape.cage), kShut_m);
}

TEST(Lids, NarrowTheEyeSteadily) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  float before = 1;
  for (float shut = 0; shut <= 1; shut += 0.1F) {
    const float gap = Gap_m(cast.topology.lids[0], composer.Compose(Wearing(0, 0, shut), Detail::kCage).cage);
    EXPECT_LT(gap, before);
    before = gap;
  }
}

// The upper lid's edge keeps its smooth curve half way: no column runs ahead of its neighbours.
TEST(Lids, KeepACleanEdgeWhenHalfShut) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  const Shape& shape = composer.Compose(Wearing(0, 0, 0.5F), Detail::kCage);
  const LidRig& rig = cast.topology.lids[0];
  for (int j = 1; j + 1 < rig.columns; ++j) {
    const auto margin = [&](int column) { return shape.cage[rig.upper[At(rig, rig.margin_ring, column)]]; };
    const glm::vec3 bend = margin(j - 1) - 2.0F * margin(j) + margin(j + 1);
    EXPECT_LT(glm::length(bend), 0.0025F) << "column " << j;
  }
}

TEST(Lids, ShutEachEyeByItself) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  Weights wink = Wearing(0, 0, 0);
  wink.lids_shut = {1, 0};
  const Shape& shape = composer.Compose(wink, Detail::kCage);
  EXPECT_LE(Gap_m(cast.topology.lids[0], shape.cage), kShut_m);
  EXPECT_GT(Gap_m(cast.topology.lids[1], shape.cage), 0.01F);
}

TEST(Lids, LeaveTheCornersOfTheEyeWhereTheyAre) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  const LidRig& rig = cast.topology.lids[0];
  const face::Index corner = rig.upper[At(rig, rig.margin_ring, 0)];
  const glm::vec3 open = composer.Compose(Wearing(0, 0, 0), Detail::kCage).cage[corner];
  const glm::vec3 shut = composer.Compose(Wearing(0, 0, 1), Detail::kCage).cage[corner];
  EXPECT_EQ(open, shut);
}

TEST(Lids, OfTheExpressionAndTheOperatorAddUpWithoutFighting) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  const auto smile = ExpressionNamed(cast, "smile");
  EXPECT_FLOAT_EQ(composer.Compose(Wearing(0, smile, 0), Detail::kCage).lids_shut[0], 0.5F);
  EXPECT_FLOAT_EQ(composer.Compose(Wearing(0, smile, 0.5F), Detail::kCage).lids_shut[0], 0.75F);
  EXPECT_FLOAT_EQ(composer.Compose(Wearing(0, smile, 1), Detail::kCage).lids_shut[0], 1);
}

TEST(Lids, PushAVertexOutOfTheVeryMiddleOfTheBall) {
  const LidRig rig{.columns = 2,
                   .rings = 1,
                   .margin_ring = 0,
                   .upper = {0, 1},
                   .lower = {0, 1},
                   .follow_upper = {1},
                   .follow_lower = {1}};
  std::vector<glm::vec3> cage{{0, 0, 0}, {0, 0, 1}};
  face::FitLids(rig, {.centre = {}, .radius_m = 0.02F, .lid_thickness_m = 0.001F}, cage);
  EXPECT_FLOAT_EQ(cage[0].z, 0.021F);
  EXPECT_FLOAT_EQ(cage[1].z, 1);
}

}  // namespace
}  // namespace kaori::tests
