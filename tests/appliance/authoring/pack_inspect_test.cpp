// What an audience must not see is found where it is planted, and not found where it is not.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "appliance/authoring/inspect/depth_picture.h"
#include "appliance/authoring/inspect/folds.h"
#include "appliance/authoring/inspect/inspect.h"
#include "appliance/authoring/inspect/lid_gaps.h"
#include "appliance/authoring/inspect/poses.h"
#include "appliance/authoring/inspect/skin.h"
#include "appliance/authoring/inspect/teeth.h"
#include "render/face/composer.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

// A flat field of quads in the plane z = 0, a millimetre wide each.
struct Field {
  static constexpr int kSide = 9;
  Field() {
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        points.emplace_back(1e-3F * static_cast<float>(x), 1e-3F * static_cast<float>(y), 0.0F);
    for (face::Index y = 0; y + 1 < kSide; ++y)
      for (face::Index x = 0; x + 1 < kSide; ++x) {
        const face::Index a = y * kSide + x;
        mesh.triangles.push_back({a, a + 1, a + kSide + 1});
        mesh.triangles.push_back({a, a + kSide + 1, a + kSide});
      }
    for (face::Index v = 0; v < points.size(); ++v) mesh.twin.push_back(v);
  }

  std::size_t Folds() const {
    const std::vector<bool> all(mesh.triangles.size(), true);
    return inspect::FindFolds(points, mesh, all).triangles.size();
  }

  std::vector<glm::vec3> points;
  face::FineMesh mesh;
};

TEST(Inspect, FindsNoFoldInAFlatOrAGentlyBentField) {
  Field field;
  EXPECT_EQ(field.Folds(), 0U);
  for (glm::vec3& p : field.points) p.z = 0.3F * p.x + 30.0F * p.y * p.y;
  EXPECT_EQ(field.Folds(), 0U);
}

TEST(Inspect, FindsTheTrianglesThatAPulledVertexTurnsOver) {
  Field field;
  field.points[4 * Field::kSide + 4].x += 2.5e-3F;  // Over its neighbour, and half way to the next.
  EXPECT_GE(field.Folds(), 2U);
}

TEST(Inspect, DoesNotCountFoldsWhereNobodySeesThem) {
  Field field;
  field.points[4 * Field::kSide + 4].x += 2.5e-3F;
  const std::vector<bool> none(field.mesh.triangles.size(), false);
  EXPECT_TRUE(inspect::FindFolds(field.points, field.mesh, none).triangles.empty());
}

face::Weights Plain(std::size_t face, float shut) {
  face::Weights weights;
  weights.faces.Push(static_cast<std::uint16_t>(face), 1);
  weights.expressions.Push(0, 1);
  weights.lids_shut = {shut, shut};
  return weights;
}

// Two balls behind a wall of one square; `hole_m` is cut out of it before the left one.
std::array<float, 2> SeenPastAWall(float hole_m) {
  constexpr float kFar_m = 0.2F;
  std::vector<glm::vec3> points;
  std::vector<face::Triangle> triangles;
  const auto add = [&](glm::vec2 low, glm::vec2 high) {
    const auto at = static_cast<face::Index>(points.size());
    for (const glm::vec2 p : {low, glm::vec2(high.x, low.y), high, glm::vec2(low.x, high.y)})
      points.emplace_back(p, 0.03F);
    triangles.push_back({at, at + 1, at + 2});
    triangles.push_back({at, at + 2, at + 3});
  };
  add({-kFar_m, -kFar_m}, {0.03F - hole_m, kFar_m});
  add({0.03F + hole_m, -kFar_m}, {kFar_m, kFar_m});
  face::Shape shape;
  shape.fine = points;
  shape.eyes = {face::EyeBall{{0.03F, 0, 0}, 0.012F, 0}, face::EyeBall{{-0.03F, 0, 0}, 0.012F, 0}};
  return inspect::BallsSeen_m2(shape, triangles);
}

TEST(Inspect, SeesNothingOfABallThatIsCovered) {
  const auto seen_m2 = SeenPastAWall(0);
  EXPECT_EQ(seen_m2[0], 0);
  EXPECT_EQ(seen_m2[1], 0);
}

TEST(Inspect, SeesTheStripOfABallBehindASlit) {
  const auto seen_m2 = SeenPastAWall(0.001F);
  EXPECT_NEAR(seen_m2[0], 0.002F * 0.024F, 0.2F * 0.002F * 0.024F);
  EXPECT_EQ(seen_m2[1], 0);
}

TEST(Inspect, TakesForSkinWhatIsSeenAndNotWhatLiesBehindIt) {
  const face::Cast cast = MakeSyntheticCast();
  face::Composer composer(cast);
  const auto& shape = composer.Compose(Plain(0, 0), face::Detail::kFine);
  const auto& triangles = cast.topology.fine.triangles;
  const auto skin = inspect::FindSkin(shape, triangles);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const glm::vec3 middle =
        (shape.fine[triangles[i][0]] + shape.fine[triangles[i][1]] + shape.fine[triangles[i][2]]) / 3.0F;
    if (middle.z < -0.08F && std::abs(middle.x) < 0.01F) {
      EXPECT_FALSE(skin[i]) << "the back of the head";
    }
    if (middle.z > 0.08F && middle.y > 0.03F) {
      EXPECT_TRUE(skin[i]) << "the forehead";
    }
  }
}

// One tooth at a place, worn by the first face, its mouth open.
struct Bite {
  explicit Bite(const glm::vec3& place) : cast(MakeSyntheticCast()) {
    face::PropVertex vertex;
    vertex.position = place;
    cast.props = {{.name = "tooth",
                   .part = face::Part::kUpperTeeth,
                   .colour = {},
                   .vertices = {vertex, vertex, vertex},
                   .triangles = {{0, 1, 2}}}};
    cast.props[0].vertices[1].position.x += 0.004F;
    cast.props[0].vertices[2].position.y += 0.004F;
    cast.faces[0].props = {0};
    cast.faces[0].mouth.upper_teeth = 1;
  }

  inspect::TeethThroughLips Find() const {
    face::Composer composer(cast);
    const auto at_rest =
        inspect::FindSkin(composer.Compose(Plain(0, 0), face::Detail::kFine), cast.topology.fine.triangles);
    face::Weights open = Plain(0, 0);
    open.channels.Push(ExpressionNamed(cast, "a"), 1);
    return inspect::FindTeethThroughLips(cast, cast.faces[0], composer.Compose(open, face::Detail::kFine),
                                         at_rest);
  }

  face::Cast cast;
};

// The skin of the reference face above the mouth, where no expression moves it far.
glm::vec3 SkinAboveTheMouth() {
  const face::Cast cast = MakeSyntheticCast();
  face::Composer composer(cast);
  const auto& shape = composer.Compose(Plain(0, 0), face::Detail::kFine);
  inspect::DepthPicture picture(inspect::WindowOver(shape.fine), 512);
  for (const auto& [a, b, c] : cast.topology.fine.triangles)
    picture.Draw(shape.fine[a], shape.fine[b], shape.fine[c]);
  const glm::vec2 place(0, -0.02F);
  return {place.x, place.y, picture.At(place)};
}

TEST(Inspect, FindsAToothThatStandsBeforeTheLip) {
  const auto through = Bite(SkinAboveTheMouth() + glm::vec3(0, 0, 0.003F)).Find();
  EXPECT_GE(through.vertices, 2);
  EXPECT_NEAR(through.farthest_m, 0.003F, 0.0015F);
}

TEST(Inspect, FindsNoneThatStandsBehindIt) {
  EXPECT_EQ(Bite(SkinAboveTheMouth() - glm::vec3(0, 0, 0.003F)).Find().vertices, 0);
}

TEST(Inspect, FindsNoneOfAFaceThatHidesItsTeeth) {
  Bite bite(SkinAboveTheMouth() + glm::vec3(0, 0, 0.003F));
  bite.cast.faces[0].mouth.upper_teeth = 0;
  EXPECT_EQ(bite.Find().vertices, 0);
}

TEST(Inspect, CountsOverAllFacesAndNamesThem) {
  const Bite bite(SkinAboveTheMouth() + glm::vec3(0, 0, 0.003F));
  std::vector<std::string> faces;
  const auto found = inspect::Inspect(bite.cast, [&](const std::string& face) { faces.push_back(face); });
  EXPECT_THAT(faces, ::testing::ElementsAre("reference", "round", "turned", "long"));
  EXPECT_GE(found.teeth_through_lips, 1);
  const auto tooth =
      std::ranges::find(found.findings, inspect::Flaw::kTeethThroughLips, &inspect::Finding::flaw);
  ASSERT_NE(tooth, found.findings.end());
  EXPECT_THAT(Say(*tooth), ::testing::MatchesRegex("reference, .*: teeth through lips by [0-9.]+ mm"));
}

TEST(Inspect, LooksAtExpressionsWithMouthsAndBrowsAndShutLids) {
  const auto poses = inspect::PosesToSee(MakeSyntheticCast().expressions);
  const auto named = [&](const std::string& name) {
    const auto pose = std::ranges::find(poses, name, &inspect::Pose::name);
    return pose == poses.end() ? nullptr : &*pose;
  };
  const auto* with_mouth = named("smile with a");
  ASSERT_NE(with_mouth, nullptr);
  EXPECT_EQ(with_mouth->weights.mouth_given_away, 1);
  EXPECT_EQ(with_mouth->weights.channels.size(), 1);
  const auto* shut = named("smile, lids shut");
  ASSERT_NE(shut, nullptr);
  EXPECT_EQ(shut->weights.lids_shut[0], 1);
  EXPECT_TRUE(shut->shut && shut->alone);
}

TEST(Inspect, PlaysTheTwoSidesOfAChannelTogether) {
  std::vector<face::Expression> expressions(4);
  expressions[0].name = "neutral";
  expressions[1].name = "smile";
  expressions[2] = {.name = "brow_up_left", .kind = face::ExpressionKind::kChannel, .displacement = {}};
  expressions[3] = {.name = "brow_up_right", .kind = face::ExpressionKind::kChannel, .displacement = {}};
  const auto poses = inspect::PosesToSee(expressions);
  const auto pose = std::ranges::find(poses, "smile with brow_up", &inspect::Pose::name);
  ASSERT_NE(pose, poses.end());
  EXPECT_EQ(pose->weights.channels.size(), 2);
  EXPECT_NE(std::ranges::find(poses, "smile with brow_up, lids shut", &inspect::Pose::name), poses.end());
}

}  // namespace
}  // namespace kaori::tests
