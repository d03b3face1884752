// Frames: how the parameter space sits on a face.
#include "render/face/frame.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace kaori::face {
namespace {

ControlNet GridOfPoints() {
  ControlNet net;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      net.points.push_back(
          {"", {0.4F + 0.04F * static_cast<float>(i), 0.4F + 0.05F * static_cast<float>(j)}});
    }
  }
  return net;
}

// The net laid on a plane: u goes along `u`, v along `v`, one metre for each metre of the parameter space.
std::vector<glm::vec3> LaidOut(const ControlNet& net, glm::vec3 u, glm::vec3 v) {
  std::vector<glm::vec3> places;
  for (const ControlPoint& p : net.points) {
    places.push_back(p.uv.x * kParameterWidth_m * u + p.uv.y * kParameterHeight_m * v);
  }
  return places;
}

void ExpectNear(const glm::vec3& got, const glm::vec3& wanted) {
  EXPECT_LT(glm::distance(got, wanted), 1e-4F);
}

TEST(Frames, AreTheParameterSpaceOnAFlatFaceOfItsSize) {
  const ControlNet net = GridOfPoints();
  for (const Frame& frame : FitFrames(net, LaidOut(net, {1, 0, 0}, {0, 1, 0}))) {
    ExpectNear(frame.along_u, {1, 0, 0});
    ExpectNear(frame.along_v, {0, 1, 0});
    ExpectNear(frame.outwards, {0, 0, 1});
  }
}

TEST(Frames, TurnAndGrowWithTheFace) {
  const ControlNet net = GridOfPoints();
  const float c = std::cos(0.7F);
  const float s = std::sin(0.7F);
  for (const Frame& frame : FitFrames(net, LaidOut(net, {2 * c, 0, -2 * s}, {0, 2, 0}))) {
    ExpectNear(frame.along_u, {2 * c, 0, -2 * s});
    ExpectNear(frame.along_v, {0, 2, 0});
    ExpectNear(frame.outwards, {2 * s, 0, 2 * c});
  }
}

TEST(Frames, KeepRightAnglesAndOneSizeWhereAFaceIsStretchedAndSheared) {
  const ControlNet net = GridOfPoints();
  for (const Frame& frame : FitFrames(net, LaidOut(net, {3, 0, 0}, {0.4F, 1, 0}))) {
    EXPECT_NEAR(glm::dot(frame.along_u, frame.along_v), 0, 1e-4);
    EXPECT_NEAR(glm::length(frame.along_u), std::sqrt(3.0F), 1e-3);
    EXPECT_NEAR(glm::length(frame.along_v), std::sqrt(3.0F), 1e-3);
    EXPECT_NEAR(glm::length(frame.outwards), std::sqrt(3.0F), 1e-3);
  }
}

TEST(Frames, FallBackToTheSpaceItselfWhereAFaceHasNoSurface) {
  const ControlNet net = GridOfPoints();
  for (const Frame& frame : FitFrames(net, LaidOut(net, {1, 0, 0}, {1, 0, 0})))
    ExpectNear(frame.outwards, {0, 0, 1});
}

TEST(Frames, SurviveASinglePoint) {
  ControlNet net;
  net.points.push_back({"only", {0.5F, 0.5F}});
  const auto frames = FitFrames(net, std::vector<glm::vec3>{{0, 0, 0}});
  ASSERT_EQ(frames.size(), 1U);
  ExpectNear(frames[0].along_u, {1, 0, 0});
}

TEST(Frames, CarryADisplacementWithTheFacesGain) {
  const std::vector<Frame> frames{{.along_u = {0, 2, 0}, .along_v = {-2, 0, 0}, .outwards = {0, 0, 2}}};
  Expression expression;
  expression.displacement = {{0.01F, 0.02F, 0.03F}};
  ExpectNear(Carry(expression, frames, 1.5F)[0], {-0.06F, 0.03F, 0.09F});
}

}  // namespace
}  // namespace kaori::face
