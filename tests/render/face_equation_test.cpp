// Equation 1 and its general form, against a reference in double precision.
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/face/composer.h"
#include "tests/render/default_cast.h"
#include "tests/render/face_reference.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

using face::Cast;
using face::Composer;
using face::Detail;
using face::Weights;

constexpr double kAllowed = 1e-6;  // Of the head's height.

// Lids ride on the ball after the sum; the sum itself is what is tested here.
Cast WithoutLids(Cast cast) {
  cast.topology.lids = {};
  return cast;
}

Weights TwoByTwo(float s1, float t1) {
  Weights w;
  w.faces.Push(0, s1);
  w.faces.Push(3, 1 - s1);
  w.expressions.Push(1, t1);
  w.expressions.Push(2, 1 - t1);
  return w;
}

TEST(Equation1, HoldsForTwoFacesAndTwoExpressions) {
  const Cast cast = WithoutLids(MakeSyntheticCast());
  Composer composer(cast);
  const auto p11 = ReferenceComposite(cast, 0, 1);
  const auto p12 = ReferenceComposite(cast, 0, 2);
  const auto p21 = ReferenceComposite(cast, 3, 1);
  const auto p22 = ReferenceComposite(cast, 3, 2);
  for (const float s : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
    for (const float t : {0.0F, 0.3F, 1.0F}) {
      const double s1 = static_cast<double>(s);
      const double t1 = static_cast<double>(t);
      Positions p(p11.size());
      for (std::size_t v = 0; v < p.size(); ++v) {
        p[v] = s1 * (t1 * p11[v] + (1 - t1) * p12[v]) + (1 - s1) * (t1 * p21[v] + (1 - t1) * p22[v]);
      }
      const auto& shape = composer.Compose(TwoByTwo(s, t), Detail::kCage);
      EXPECT_LE(LargestError_m(p, shape.cage), kAllowed * HeadHeight_m(cast)) << "s1 " << s << ", t1 " << t;
    }
  }
}

// Weights of a busy moment: fades that overtake each other, channels on top, the mouth partly given away.
Weights RandomWeights(std::mt19937& random, const Cast& cast) {
  std::uniform_real_distribution<float> part(0, 1);
  const auto fill = [&](face::Terms& terms, std::size_t count, float sum) {
    std::array<float, 4> parts{part(random), part(random), part(random), part(random)};
    const float all = parts[0] + parts[1] + parts[2] + parts[3];
    for (const float p : parts) terms.Push(static_cast<std::uint16_t>(random() % count), sum * p / all);
  };
  Weights w;
  fill(w.faces, cast.faces.size(), 1);
  fill(w.expressions, cast.expressions.size(), 1);
  fill(w.channels, cast.expressions.size(), 2);
  w.mouth_given_away = part(random);
  return w;
}

void ExpectRandomWeightsToAgree(const Cast& cast, int rounds) {
  Composer composer(cast);
  std::mt19937 random(7);
  for (int i = 0; i < rounds; ++i) {
    const Weights w = RandomWeights(random, cast);
    const auto& shape = composer.Compose(w, Detail::kCage);
    ASSERT_LE(LargestError_m(ReferenceShape(cast, w), shape.cage), kAllowed * HeadHeight_m(cast))
        << "round " << i;
  }
}

TEST(Equation1, HoldsInItsGeneralFormWithChannels) {
  ExpectRandomWeightsToAgree(WithoutLids(MakeSyntheticCast()), 20);
}

TEST(Equation1, HoldsForTheDefaultCast) {
  ExpectRandomWeightsToAgree(WithoutLids(DefaultCast()), 8);
}

// The paper's section 2: the deformations of face and expression, computed each for itself and then added,
// are not the face wearing the expression.
TEST(Composing, DiffersFromAddingTheTwoDeformations) {
  const Cast cast = WithoutLids(MakeSyntheticCast());
  Composer composer(cast);
  const auto smile = ReferenceComposite(cast, 0, 1);
  Weights w;
  w.faces.Push(2, 1);  // The turned and larger face.
  w.expressions.Push(1, 1);
  const auto& shape = composer.Compose(w, Detail::kCage);
  double largest_m = 0;
  for (std::size_t v = 0; v < smile.size(); ++v) {
    const glm::dvec3 base{cast.faces[0].positions[v]};
    const glm::dvec3 added = glm::dvec3(cast.faces[2].positions[v]) + (smile[v] - base);
    largest_m = std::max(largest_m, glm::distance(added, glm::dvec3(shape.cage[v])));
  }
  EXPECT_GT(largest_m, 0.001);
}

TEST(Composing, IsContinuousInTheWeights) {
  const Cast cast = MakeSyntheticCast();
  Composer composer(cast);
  const auto first = composer.Compose(TwoByTwo(0.5F, 0.5F), Detail::kCage).cage;
  const std::vector<glm::vec3> before(first.begin(), first.end());
  const auto after = composer.Compose(TwoByTwo(0.501F, 0.499F), Detail::kCage).cage;
  for (std::size_t v = 0; v < before.size(); ++v) ASSERT_LT(glm::distance(before[v], after[v]), 0.001F);
}

}  // namespace
}  // namespace kaori::tests
