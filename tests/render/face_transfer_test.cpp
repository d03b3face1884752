// An expression keeps its meaning on another face: the corners of the mouth rise in a smile, brows rise, jaws
// drop.
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/face/composer.h"
#include "render/face/frame.h"
#include "tests/render/default_cast.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

using face::Cast;
using face::Composer;
using face::Detail;

// Where the control points lie on a face that wears an expression.
std::vector<glm::vec3> Points(Composer& composer, const Cast& cast, std::size_t face,
                              std::uint16_t expression) {
  face::Weights w;
  w.faces.Push(static_cast<std::uint16_t>(face), 1);
  w.expressions.Push(expression, 1);
  return face::PointsOnFace(cast.net, composer.Compose(w, Detail::kCage).cage);
}

// How far named points move in an expression on a face, metres.
class Motion {
 public:
  Motion(Composer& composer, const Cast& cast, std::size_t face, const char* expression)
      : cast_(cast),
        before_(Points(composer, cast, face, 0)),
        after_(Points(composer, cast, face, ExpressionNamed(cast, expression))) {}

  float Up_m(const char* point) const { return after_[At(point)].y - before_[At(point)].y; }
  float Apart_m(const char* a, const char* b) const {
    return glm::distance(after_[At(a)], after_[At(b)]) - glm::distance(before_[At(a)], before_[At(b)]);
  }

 private:
  std::size_t At(const char* point) const { return PointNamed(cast_, point); }

  const Cast& cast_;
  std::vector<glm::vec3> before_;
  std::vector<glm::vec3> after_;
};

void ExpectSmiles(const Cast& cast) {
  Composer composer(cast);
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    const Motion smile(composer, cast, i, "smile");
    EXPECT_GT(smile.Up_m("MC.l"), 0.0015F) << cast.faces[i].name;
    EXPECT_GT(smile.Up_m("MC.r"), 0.0015F) << cast.faces[i].name;
    EXPECT_GT(smile.Apart_m("MC.l", "MC.r"), 0.0015F) << cast.faces[i].name;
  }
}

void ExpectSurprise(const Cast& cast) {
  Composer composer(cast);
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    const Motion surprise(composer, cast, i, "surprised");
    EXPECT_GT(surprise.Up_m("B2.l"), 0.0015F) << cast.faces[i].name;
    EXPECT_LT(surprise.Up_m("LC"), -0.0015F) << cast.faces[i].name;
    EXPECT_GT(surprise.Apart_m("UC", "LC"), 0.0015F) << cast.faces[i].name;
  }
}

void ExpectOpenMouths(const Cast& cast) {
  Composer composer(cast);
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    EXPECT_GT(Motion(composer, cast, i, "a").Apart_m("UC", "LC"), 0.003F) << cast.faces[i].name;
  }
}

TEST(Transfer, ASmileLiftsTheCornersOfEveryMouth) {
  ExpectSmiles(MakeSyntheticCast());
}
TEST(Transfer, SurpriseLiftsBrowsAndDropsTheJawOfEveryFace) {
  ExpectSurprise(MakeSyntheticCast());
}
TEST(Transfer, AnAOpensEveryMouth) {
  ExpectOpenMouths(MakeSyntheticCast());
}

TEST(Transfer, KeepsItsMeaningOnEveryFaceOfTheDefaultCast) {
  ExpectSmiles(DefaultCast());
  ExpectSurprise(DefaultCast());
  ExpectOpenMouths(DefaultCast());
}

TEST(Transfer, GrowsWithTheFace) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  const float on_reference = Motion(composer, cast, 0, "surprised").Up_m("B2.l");
  const float on_larger = Motion(composer, cast, 2, "surprised").Up_m("B2.l");
  EXPECT_NEAR(on_larger / on_reference, 1.3F, 0.01F);
}

TEST(Transfer, TurnsWithTheFace) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  const std::size_t corner = PointNamed(cast, "MC.l");
  const auto smile = ExpressionNamed(cast, "smile");
  const glm::vec3 on_reference =
      Points(composer, cast, 0, smile)[corner] - Points(composer, cast, 0, 0)[corner];
  const glm::vec3 on_turned = Points(composer, cast, 2, smile)[corner] - Points(composer, cast, 2, 0)[corner];
  const float c = std::cos(0.5236F);
  const float s = std::sin(0.5236F);
  const glm::vec3 wanted = 1.3F * glm::vec3{c * on_reference.x + s * on_reference.z, on_reference.y,
                                            c * on_reference.z - s * on_reference.x};
  EXPECT_LT(glm::distance(on_turned, wanted), 1e-5F);
}

TEST(Transfer, TriesHarderWhereTheFaceHasToldItTo) {
  Cast cast = MakeSyntheticCast();
  const float plain = Motion(*std::make_unique<Composer>(cast), cast, 0, "smile").Up_m("MC.l");
  cast.faces[0].expression_gain = 1.6F;
  const float hard = Motion(*std::make_unique<Composer>(cast), cast, 0, "smile").Up_m("MC.l");
  EXPECT_NEAR(hard / plain, 1.6F, 0.001F);
}

}  // namespace
}  // namespace kaori::tests
