// The composer as its callers see it: what it gives, what it refuses, what it costs.
#include "render/face/composer.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "hw-sim/evening/allocations.h"
#include "tests/render/face_reference.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

using face::Cast;
using face::Composer;
using face::Detail;
using face::Shape;
using face::Weights;

constexpr float kComposerNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Weights Wearing(std::uint16_t face, std::uint16_t expression) {
  Weights w;
  w.faces.Push(face, 1);
  w.expressions.Push(expression, 1);
  return w;
}

std::vector<glm::vec3> Cage(Composer& composer, const Weights& weights) {
  const auto cage = composer.Compose(weights, Detail::kCage).cage;
  return {cage.begin(), cage.end()};
}

TEST(Composer, AllocatesNothing) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  Weights busy;
  for (std::uint16_t i = 0; i < 40; ++i) {
    busy.faces.Push(i % 4, 0.03F);
    busy.expressions.Push(i % 6, 0.03F);
    busy.channels.Push(i % 6, 0.5F);
  }
  busy.mouth_given_away = 0.5F;
  const std::size_t before = sim::AllocationCount();
  composer.Compose(busy, Detail::kFine);
  composer.Compose(Wearing(1, 1), Detail::kCage);
  EXPECT_EQ(sim::AllocationCount(), before);
  EXPECT_GT(before, 0U);
}

TEST(Composer, WearsAnExpressionAsItWasMadeAnewOnEveryFace) {
  Cast cast = MakeSyntheticCast();
  const std::size_t point = PointNamed(cast, "MC.l");
  cast.expressions.push_back(
      {.name = "blank", .displacement = std::vector<glm::vec3>(cast.net.points.size())});
  const auto blank = static_cast<std::uint16_t>(cast.expressions.size() - 1);
  Composer composer(cast);
  const auto smile = Cage(composer, Wearing(2, 1));
  for (const float pull_m : {0.004F, -0.007F, 0.0F}) {
    cast.expressions[blank].displacement[point] = {0, pull_m, pull_m};
    cast.expressions[blank].lids = {pull_m > 0 ? 0.5F : 0.0F, 0};
    composer.Renew(blank);
    Composer fresh(cast);
    for (std::uint16_t face = 0; face < cast.faces.size(); ++face)
      EXPECT_EQ(Cage(composer, Wearing(face, blank)), Cage(fresh, Wearing(face, blank))) << pull_m << face;
  }
  EXPECT_EQ(Cage(composer, Wearing(2, 1)), smile) << "the others are as they were";
}

TEST(Composer, AllocatesNothingForAnExpressionThatIsPulledOnFrameByFrame) {
  Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  const std::size_t before = sim::AllocationCount();
  for (int frame = 0; frame < 10; ++frame) {
    cast.expressions[1].displacement[0].y += 0.001F;
    composer.Renew(1);
    composer.Compose(Wearing(frame % 4U, 1), Detail::kFine);
  }
  EXPECT_EQ(sim::AllocationCount(), before);
}

TEST(Composer, ShowsTheReferenceFaceWhenNoFaceHasWeight) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  EXPECT_EQ(Cage(composer, {}), Cage(composer, Wearing(0, 0)));
}

TEST(Composer, LeavesOutWeightsThatAreNoNumbersOrNameNothing) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  Weights spoiled = Wearing(1, 2);
  spoiled.faces.Push(2, kComposerNan);
  spoiled.faces.Push(9999, 1);
  spoiled.expressions.Push(1, kInfinity);
  spoiled.expressions.Push(9999, 1);
  spoiled.channels.Push(4, -kInfinity);
  spoiled.mouth_given_away = kComposerNan;
  spoiled.lids_shut = {kComposerNan, kInfinity};
  EXPECT_EQ(Cage(composer, spoiled), Cage(composer, Wearing(1, 2)));
}

TEST(Composer, StaysFiniteWhateverTheWeights) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  Weights wild = Wearing(0, 1);
  wild.faces.Push(1, -1e30F);
  wild.expressions.Push(2, 1e30F);
  wild.channels.Push(3, -1e30F);
  wild.lids_shut = {1e30F, -1e30F};
  const Shape& shape = composer.Compose(wild, Detail::kFine);
  for (const glm::vec3& p : shape.fine) ASSERT_LT(glm::length(p), 10);
  for (const glm::vec3& n : shape.fine_normals) ASSERT_NEAR(glm::length(n), 1, 1e-3);
}

TEST(Composer, KeepsTheHeadsSizeWhenFaceWeightsDoNotSumToOne) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  Weights half;
  half.faces.Push(0, 0.4F);
  Weights whole;
  whole.faces.Push(0, 1);
  EXPECT_EQ(Cage(composer, half), Cage(composer, whole));
}

TEST(Composer, GivesTheMouthAwayButNotTheBrows) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  Weights w = Wearing(0, ExpressionNamed(cast, "surprised"));
  w.mouth_given_away = 1;
  const auto given = Cage(composer, w);
  const auto rest = Cage(composer, Wearing(0, 0));
  w.mouth_given_away = 0;
  const auto kept = Cage(composer, w);
  const auto at = [&](const char* point) { return cast.net.surface.column[PointNamed(cast, point)]; };
  EXPECT_NEAR(given[at("LC")].y, rest[at("LC")].y, 1e-6F);
  EXPECT_LT(kept[at("LC")].y, rest[at("LC")].y - 0.005F);
  EXPECT_NEAR(given[at("B2.l")].y, kept[at("B2.l")].y, 1e-6F);
}

TEST(Composer, TellsHowFarTheJawDropped) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  EXPECT_EQ(composer.Compose(Wearing(0, 0), Detail::kCage).jaw_drop_m, 0);
  Weights w = Wearing(0, 0);
  w.channels.Push(ExpressionNamed(cast, "a"), 1);
  const float drop_m = composer.Compose(w, Detail::kCage).jaw_drop_m;
  EXPECT_GT(drop_m, 0.01F);
  EXPECT_LT(drop_m, 0.03F);
  w.channels.clear();
  w.channels.Push(ExpressionNamed(cast, "a"), -1);
  EXPECT_EQ(composer.Compose(w, Detail::kCage).jaw_drop_m, 0);
}

// At the ends and among faces of one kind equation 1 holds to the last bit.
TEST(Composer, WithdrawsOutgrowthsBetweenFacesOfTwoKindsAlone) {
  Cast cast = MakeSyntheticCast();
  const Cast plain = cast;
  cast.topology.outgrowth = {5};
  for (face::Face& face : cast.faces) face.withdrawn = {{0, 1, 0}};
  cast.faces[1].outgrowth_kind = 1;
  Composer composer(cast);
  Composer without(plain);
  const auto rises_m = [&](std::uint16_t a, std::uint16_t b, float share) {
    Weights w;
    w.faces.Push(a, 1 - share);
    w.faces.Push(b, share);
    return composer.Compose(w, Detail::kCage).cage[5].y - without.Compose(w, Detail::kCage).cage[5].y;
  };
  EXPECT_EQ(rises_m(0, 1, 0), 0);
  EXPECT_EQ(rises_m(0, 1, 1), 0);
  EXPECT_EQ(rises_m(0, 2, 0.5F), 0);
  EXPECT_NEAR(rises_m(0, 1, 0.5F), 1, 1e-5);
  EXPECT_GT(rises_m(0, 1, 0.25F), 0.9F);
}

// Vertex 5 hangs from the upper joint alone, vertex 9 from both; the sides are those of the face at rest.
TEST(Composer, SwingsWhatHangsFromAFaceByItsWeight) {
  Cast cast = MakeSyntheticCast();
  cast.topology.outgrowth = {5, 9};
  cast.faces[1].positions[5].x = 0.1F;
  cast.faces[1].positions[9].x = -0.1F;
  cast.faces[1].hang_arms_m = {{0.02F, 0}, {0.04F, 0.03F}};
  Composer composer(cast);
  const auto swung = [&](float share, std::size_t vertex) {
    Weights w;
    w.faces.Push(0, 1 - share);
    w.faces.Push(1, share);
    const glm::vec3 rest = composer.Compose(w, Detail::kCage).cage[vertex];
    w.hanging[0] = {{0.5F, -0.25F}, {9, 9}};
    w.hanging[1] = {{-0.5F, 0.25F}, {0.1F, 0.2F}};
    return composer.Compose(w, Detail::kCage).cage[vertex] - rest;
  };
  const auto near = [](glm::vec3 a, glm::vec3 b) { return glm::distance(a, b) < 1e-6F; };
  EXPECT_TRUE(near(swung(1, 5), {0.01F, 0, -0.005F}));
  EXPECT_TRUE(near(swung(1, 9), {-0.02F + 0.003F, 0, 0.01F + 0.006F}));
  EXPECT_TRUE(near(swung(0.5F, 5), {0.005F, 0, -0.0025F}));
  EXPECT_EQ(swung(0, 5), glm::vec3(0)) << "of the other face nothing hangs";
}

TEST(Composer, SwingsNothingByWhatIsNoAngle) {
  Cast cast = MakeSyntheticCast();
  cast.topology.outgrowth = {5};
  cast.faces[0].hang_arms_m = {{0.1F, 0}};
  Composer composer(cast);
  Weights w;
  w.faces.Push(0, 1);
  const glm::vec3 rest = composer.Compose(w, Detail::kCage).cage[5];
  w.hanging[0].upper_rad = w.hanging[1].upper_rad = {std::numeric_limits<float>::quiet_NaN(), 900};
  const glm::vec3 swung = composer.Compose(w, Detail::kCage).cage[5] - rest;
  EXPECT_EQ(swung.x, 0);
  EXPECT_NEAR(swung.z, 0.1F * face::kFarthestHanging_rad, 1e-6F);
}

TEST(Composer, BlendsOcclusionAndFollowsANewFade) {
  Cast cast = MakeSyntheticCast();
  cast.faces[1].occlusion.assign(cast.topology.vertex_count, 0.5F);
  cast.faces[2].occlusion.clear();  // Open everywhere.
  Composer composer(cast);
  Weights w;
  w.faces.Push(0, 0.5F);
  w.faces.Push(1, 0.5F);
  EXPECT_FLOAT_EQ(composer.Compose(w, Detail::kCage).occlusion[7], 0.75F);
  EXPECT_FLOAT_EQ(composer.Compose(w, Detail::kFine).fine_occlusion[7], 0.75F);
  EXPECT_FLOAT_EQ(composer.Compose(Wearing(1, 0), Detail::kFine).fine_occlusion[7], 0.5F);
  EXPECT_FLOAT_EQ(composer.Compose(Wearing(2, 0), Detail::kFine).fine_occlusion[7], 1);
}

TEST(Composer, LeavesTheFineMeshOutAtTheCagesDetail) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  EXPECT_TRUE(composer.Compose({}, Detail::kCage).fine.empty());
  EXPECT_EQ(composer.Compose({}, Detail::kFine).fine.size(), cast.topology.fine.from_cage.rows());
  EXPECT_EQ(composer.Compose({}, Detail::kFine).cage.size(), cast.topology.vertex_count);
}

TEST(Composer, PutsTheFineMeshWhereItsMatrixSays) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  const Shape& shape = composer.Compose(Wearing(3, 2), Detail::kFine);
  const auto& rows = cast.topology.fine.from_cage;
  for (std::size_t r = 0; r < rows.rows(); ++r) {
    glm::vec3 wanted{};
    for (auto i = rows.row_start[r]; i < rows.row_start[r + 1]; ++i)
      wanted += rows.weight[i] * shape.cage[rows.column[i]];
    ASSERT_LT(glm::distance(wanted, shape.fine[r]), 1e-6F);
  }
}

TEST(Terms, DropTheLightestWhenThereAreTooMany) {
  face::Terms terms;
  for (std::uint16_t i = 0; i < face::Terms::kCapacity; ++i) terms.Push(i, i == 5 ? 0.01F : 0.5F);
  terms.Push(99, 0.4F);
  EXPECT_EQ(terms.size(), face::Terms::kCapacity);
  EXPECT_EQ(terms[5].index, 99);
  terms.Push(100, 0.001F);
  EXPECT_EQ(terms[5].index, 99);
}

}  // namespace
}  // namespace kaori::tests
