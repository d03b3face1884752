// The control net and the expressions of the default show.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/texture_map.h"
#include "render/face/composer.h"
#include "tests/appliance/authoring/sculpt_fixture.h"

namespace kaori::tests {
namespace {

using face::Index;
using sculpt::Cage;
using sculpt::Region;

const face::ControlNet& Net() {
  return SculptedCast().net;
}

std::size_t Point(const std::string& name) {
  const auto found = std::find_if(Net().points.begin(), Net().points.end(),
                                  [&name](const face::ControlPoint& p) { return p.name == name; });
  EXPECT_NE(found, Net().points.end()) << name;
  return static_cast<std::size_t>(found - Net().points.begin());
}

std::size_t Named(const std::string& name) {
  const auto& expressions = SculptedCast().expressions;
  const auto found = std::find_if(expressions.begin(), expressions.end(),
                                  [&name](const face::Expression& e) { return e.name == name; });
  EXPECT_NE(found, expressions.end()) << name;
  return static_cast<std::size_t>(found - expressions.begin());
}

float WeightAt(const face::SparseRows& rows, Index row, std::size_t point) {
  for (auto i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i) {
    if (rows.column[i] == point) return rows.weight[i];
  }
  return 0;
}

TEST(ControlNet, HasAHundredPointsOrSoThatSitOnTheFace) {
  EXPECT_EQ(Net().points.size(), 97U);
  const face::Face& kaori = SculptedCast().faces[0];
  for (std::size_t p = 0; p < Net().points.size(); ++p) {
    glm::vec3 on_face{};
    for (auto i = Net().surface.row_start[p]; i < Net().surface.row_start[p + 1]; ++i) {
      on_face += Net().surface.weight[i] * kaori.positions[Net().surface.column[i]];
    }
    // In front, the unrolled surface is the face seen from the front.
    const glm::dvec2 extent_cm = sculpt::kUvMax_cm - sculpt::kUvMin_cm;
    const glm::dvec2 uv_cm = sculpt::kUvMin_cm + glm::dvec2(Net().points[p].uv) * extent_cm;
    if (std::abs(uv_cm.x) > 3.5 || uv_cm.y < -7) continue;
    EXPECT_LT(glm::distance(uv_cm, 100.0 * glm::dvec2(on_face)), 0.6) << Net().points[p].name;
  }
}

TEST(ControlNet, TakesAPointExactlyToItsVertexOnTheLid) {
  const Cage cage = sculpt::BuildCage();
  const Index lid = cage.left[cage.half.At(Region::kEye, 7, sculpt::kLidRing)];
  EXPECT_NEAR(WeightAt(Net().to_cage, lid, Point("U2.l")), 1, 1e-5);
}

TEST(ControlNet, NeverMixesTheLips) {
  const Cage cage = sculpt::BuildCage();
  for (int j = 0; j < sculpt::kMouthCorner; ++j) {
    const Index upper = cage.left[cage.half.At(Region::kMouth, j, sculpt::kLipContactRing)];
    const Index lower =
        cage.left[cage.half.At(Region::kMouth, sculpt::kMouthRim - 1 - j, sculpt::kLipContactRing)];
    for (const char* name : {"LC", "LC1.l", "LC2.l", "LB", "LB1.l"}) {
      EXPECT_EQ(WeightAt(Net().to_cage, upper, Point(name)), 0) << name << " " << j;
    }
    for (const char* name : {"UC", "UC1.l", "UC2.l", "UB", "UB1.l"}) {
      EXPECT_EQ(WeightAt(Net().to_cage, lower, Point(name)), 0) << name << " " << j;
    }
  }
}

TEST(ControlNet, IsTheSameLeftAndRight) {
  const Cage cage = sculpt::BuildCage();
  for (Index half = 0; half < cage.left.size(); ++half) {
    if (cage.left[half] >= cage.moving_count) continue;
    for (const char* name : {"MC", "K1", "U2", "B1", "J3"}) {
      const float left = WeightAt(Net().to_cage, cage.left[half], Point(std::string(name) + ".l"));
      const float right = WeightAt(Net().to_cage, cage.right[half], Point(std::string(name) + ".r"));
      ASSERT_EQ(left, right) << name << " " << half;
    }
  }
}

TEST(ControlNet, FadesOutBeforeTheFaceThatCannotMove) {
  const Cage cage = sculpt::BuildCage();
  for (Index v = 0; v < cage.moving_count; ++v) {
    const sculpt::Key& key = cage.key(v);
    const bool last = key.region == Region::kGrid && (key.a == 16 || key.b == 3 || key.b == 33);
    float sum = 0;
    for (auto i = Net().to_cage.row_start[v]; i < Net().to_cage.row_start[v + 1]; ++i)
      sum += Net().to_cage.weight[i];
    EXPECT_LE(sum, 1.0001F);
    if (last) {
      EXPECT_LT(sum, 0.02F) << key.a << " " << key.b;
    }
  }
}

TEST(Expressions, BeginWithAFaceAtRest) {
  const face::Expression& neutral = SculptedCast().expressions.front();
  EXPECT_EQ(neutral.name, "neutral");
  EXPECT_TRUE(std::all_of(neutral.displacement.begin(), neutral.displacement.end(),
                          [](const glm::vec3& d) { return d == glm::vec3(0); }));
}

TEST(Expressions, CoverTheRangeOfThePlay) {
  const auto& all = SculptedCast().expressions;
  const auto count = [&all](face::ExpressionKind kind) {
    return std::count_if(all.begin(), all.end(),
                         [kind](const face::Expression& e) { return e.kind == kind; });
  };
  EXPECT_GE(count(face::ExpressionKind::kExpression), 14);
  EXPECT_GE(count(face::ExpressionKind::kMouth), 11);
  EXPECT_GE(count(face::ExpressionKind::kChannel), 6);
  for (const char* name :
       {"smile", "laugh", "funny", "perplexed", "angry", "boiling", "sad", "farewell", "in_love", "surprised",
        "afraid", "disgusted", "sleepy", "proud", "barking", "wink"}) {
    EXPECT_EQ(all[Named(name)].kind, face::ExpressionKind::kExpression) << name;
  }
}

TEST(Expressions, AreMirroredUnlessOneSideIsNamed) {
  const face::Expression& smile = SculptedCast().expressions[Named("smile")];
  EXPECT_EQ(smile.displacement[Point("MC.l")] * glm::vec3(-1, 1, 1), smile.displacement[Point("MC.r")]);
  const face::Expression& wink = SculptedCast().expressions[Named("wink")];
  EXPECT_EQ(wink.lids[0], 1);
  EXPECT_EQ(wink.lids[1], 0);
  EXPECT_GT(wink.displacement[Point("K1.l")].y, wink.displacement[Point("K1.r")].y);
}

TEST(Expressions, MayMakeFacesRed) {
  EXPECT_EQ(SculptedCast().expressions[Named("boiling")].flush, 1);
  EXPECT_EQ(SculptedCast().expressions[Named("smile")].flush, 0);
}

TEST(Expressions, MayHaveLargerPupils) {
  EXPECT_FLOAT_EQ(SculptedCast().expressions[Named("in_love")].pupil, 1.12F);
  EXPECT_EQ(SculptedCast().expressions[Named("smile")].pupil, 1);
}

TEST(Expressions, TheFourMouthShapesMeetAtRestInTheMiddle) {
  const auto& all = SculptedCast().expressions;
  const auto half = [&all](const char* a, const char* b, std::size_t point) {
    return 0.5F * (all[Named(a)].displacement[point] + all[Named(b)].displacement[point]);
  };
  for (std::size_t p = 0; p < Net().points.size(); ++p) {
    const glm::vec3 shut = half("mouth_shut_narrow", "mouth_shut_wide", p);
    EXPECT_LT(glm::length(shut), 0.002F) << Net().points[p].name;
  }
  EXPECT_LT(half("mouth_open_narrow", "mouth_open_wide", Point("LC")).y, -0.012F);
}

// What is true of an expression must be true of it on every face.
class OnEveryFace : public ::testing::Test {
 protected:
  // How far a point goes on face f, in millimetres.
  glm::vec3 Motion_mm(std::uint16_t f, const char* expression, const char* point) {
    return 1000.0F * (At(f, expression, point) - At(f, "neutral", point));
  }

  glm::vec3 At(std::uint16_t f, const char* expression, const char* point) {
    face::Weights weights;
    weights.faces.Push(f, 1);
    weights.expressions.Push(static_cast<std::uint16_t>(Named(expression)), 1);
    const face::Shape& shape = composer_.Compose(weights, face::Detail::kCage);
    glm::vec3 p{};
    const std::size_t row = Point(point);
    for (auto i = Net().surface.row_start[row]; i < Net().surface.row_start[row + 1]; ++i) {
      p += Net().surface.weight[i] * shape.cage[Net().surface.column[i]];
    }
    return p;
  }

  std::uint16_t faces() const { return static_cast<std::uint16_t>(SculptedCast().faces.size()); }

 private:
  face::Composer composer_{SculptedCast()};
};

TEST_F(OnEveryFace, ASmileLiftsTheCornersOfTheMouthApart) {
  for (std::uint16_t f = 0; f < faces(); ++f) {
    EXPECT_GT(Motion_mm(f, "smile", "MC.l").y, 2) << SculptedCast().faces[f].name;
    EXPECT_GT(Motion_mm(f, "smile", "MC.l").x, 2) << SculptedCast().faces[f].name;
    EXPECT_LT(Motion_mm(f, "smile", "MC.r").x, -2) << SculptedCast().faces[f].name;
  }
}

TEST_F(OnEveryFace, SorrowDropsTheCornersAndLiftsTheBrowsInside) {
  for (std::uint16_t f = 0; f < faces(); ++f) {
    EXPECT_LT(Motion_mm(f, "sad", "MC.l").y, -2) << SculptedCast().faces[f].name;
    EXPECT_GT(Motion_mm(f, "sad", "B1.r").y, Motion_mm(f, "sad", "B4.r").y + 3)
        << SculptedCast().faces[f].name;
  }
}

TEST_F(OnEveryFace, AngerDrawsTheBrowsDownAndTogether) {
  for (std::uint16_t f = 0; f < faces(); ++f) {
    EXPECT_LT(Motion_mm(f, "angry", "B1.l").y, -2) << SculptedCast().faces[f].name;
    EXPECT_LT(Motion_mm(f, "angry", "B1.l").x, 0) << SculptedCast().faces[f].name;
  }
}

TEST_F(OnEveryFace, SurpriseBarkAndVowelOpenTheMouth) {
  for (std::uint16_t f = 0; f < faces(); ++f) {
    for (const char* name : {"surprised", "barking", "laugh"}) {
      const glm::vec3 gap_mm = 1000.0F * (At(f, name, "UC") - At(f, name, "LC"));
      EXPECT_GT(glm::length(gap_mm), 6) << name << " " << SculptedCast().faces[f].name;
    }
  }
}

TEST_F(OnEveryFace, NoTwoMouthShapesLookAlike) {
  constexpr float kApart_mm = 2;
  constexpr std::array kShapes{"neutral",          "a", "i", "u", "e", "o", "m", "f", "mouth_shut_wide",
                               "mouth_open_narrow"};
  const auto apart_mm = [this](std::uint16_t f, const char* a, const char* b) {
    float most = 0;
    for (const char* point : {"MC.l", "UC", "LC", "UB", "LB"}) {
      most = std::max(most, glm::distance(1000.0F * At(f, a, point), 1000.0F * At(f, b, point)));
    }
    return most;
  };
  for (std::uint16_t f = 0; f < faces(); ++f) {
    for (std::size_t a = 0; a < kShapes.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_GT(apart_mm(f, kShapes[a], kShapes[b]), kApart_mm)
            << kShapes[a] << " and " << kShapes[b] << " on " << SculptedCast().faces[f].name;
      }
    }
  }
}

TEST_F(OnEveryFace, PursedLipsComeForward) {
  for (std::uint16_t f = 0; f < faces(); ++f) {
    EXPECT_GT(Motion_mm(f, "u", "UC").z, 3) << SculptedCast().faces[f].name;
    EXPECT_LT(Motion_mm(f, "u", "MC.l").x, -3) << SculptedCast().faces[f].name;
  }
}

}  // namespace
}  // namespace kaori::tests
