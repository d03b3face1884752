// The few numbers of a face that are blended with it.
#include "render/face/mix.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/face/composer.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

using face::Cast;
using face::Composer;
using face::Detail;
using face::Shape;
using face::Weights;

TEST(Mix, ExpressionsMakeThePupilsLargerByTheirWeights) {
  Cast cast = MakeSyntheticCast();
  const auto smile = ExpressionNamed(cast, "smile");
  cast.expressions[smile].pupil = 1.2F;
  Composer composer(cast);
  Weights w;
  w.faces.Push(0, 1);
  const float at_rest = composer.Compose(w, Detail::kCage).eye_surface.pupil;
  w.expressions.Push(smile, 0.5F);
  EXPECT_FLOAT_EQ(composer.Compose(w, Detail::kCage).eye_surface.pupil, 1.1F * at_rest);
}

TEST(Mix, FacesThatShowItFlushByTheWeightsOfExpressions) {
  Cast cast = MakeSyntheticCast();
  const auto smile = ExpressionNamed(cast, "smile");
  cast.expressions[smile].flush = 0.8F;
  cast.faces[1].surface.flush = 1;
  Composer composer(cast);
  Weights w;
  w.faces.Push(0, 0.75F);
  w.faces.Push(1, 0.25F);
  EXPECT_EQ(composer.Compose(w, Detail::kCage).flush, 0);
  w.expressions.Push(smile, 0.5F);
  EXPECT_FLOAT_EQ(composer.Compose(w, Detail::kCage).flush, 0.1F);
  w.expressions.clear();
  w.expressions.Push(smile, 3);
  EXPECT_FLOAT_EQ(composer.Compose(w, Detail::kCage).flush, 0.25F) << "no redder than red";
}

TEST(Mix, BlendsEyesLookAndMouthWithTheFaces) {
  Cast cast = MakeSyntheticCast();
  cast.faces[1].mouth.scale = 3;
  cast.faces[1].mouth.lower_teeth = 0;
  cast.faces[1].eye_look.iris = {1, 0, 0};
  cast.faces[0].eye_look.iris = {0, 0, 0};
  cast.faces[0].eye_surface = {.white = {1, 1, 1}, .pupil = 0.2F, .wet = 0};
  cast.faces[1].eye_surface = {.white = {0, 0, 0}, .pupil = 0.6F, .wet = 1, .glow = 1};
  Composer composer(cast);
  Weights w;
  w.faces.Push(0, 0.75F);
  w.faces.Push(1, 0.25F);
  const Shape& shape = composer.Compose(w, Detail::kCage);
  EXPECT_FLOAT_EQ(shape.mouth.scale, 1.5F);
  EXPECT_FLOAT_EQ(shape.mouth.lower_teeth, 0.75F);
  EXPECT_FLOAT_EQ(shape.eye_look.iris.r, 0.25F);
  EXPECT_FLOAT_EQ(shape.eye_surface.white.g, 0.75F);
  EXPECT_FLOAT_EQ(shape.eye_surface.pupil, 0.3F);
  EXPECT_FLOAT_EQ(shape.eye_surface.wet, 0.25F);
  EXPECT_FLOAT_EQ(shape.eye_surface.glow, 0.25F);
  const glm::vec3 wanted = 0.75F * cast.faces[0].eyes[0].centre + 0.25F * cast.faces[1].eyes[0].centre;
  EXPECT_LT(glm::distance(shape.eyes[0].centre, wanted), 1e-6F);
}

}  // namespace
}  // namespace kaori::tests
