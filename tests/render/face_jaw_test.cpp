// What is played on top of an expression opens the jaw no second time, and lids stay whole while a face turns
// into another.
#include "render/face/jaw.h"

#include <gtest/gtest.h>

#include "appliance/authoring/inspect/folds.h"
#include "appliance/authoring/inspect/lid_gaps.h"
#include "appliance/authoring/inspect/skin.h"
#include "render/face/composer.h"
#include "tests/render/default_cast.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

float Drop_m(const face::Cast& cast, face::Weights weights) {
  weights.faces.Push(0, 1);
  face::LimitJaw(cast, weights);
  face::Composer composer(cast);
  return composer.Compose(weights, face::Detail::kCage).jaw_drop_m;
}

face::Weights Playing(const face::Cast& cast, const char* expression, float jaw_open) {
  face::Weights weights;
  weights.expressions.Push(ExpressionNamed(cast, expression), 1);
  if (jaw_open > 0) weights.channels.Push(ExpressionNamed(cast, "jaw_open"), jaw_open);
  return weights;
}

TEST(Jaw, OpensAFaceAtRestAsFarAsTheChannelSays) {
  const face::Cast& cast = DefaultCast();
  face::Weights weights = Playing(cast, "neutral", 0.5F);
  face::LimitJaw(cast, weights);
  ASSERT_EQ(weights.channels.size(), 1);
  EXPECT_FLOAT_EQ(weights.channels[0].weight, 0.5F);
}

TEST(Jaw, GoesNoFurtherThanTheWidestExpression) {
  const face::Cast& cast = DefaultCast();
  float widest_m = 0;
  for (std::uint16_t j = 0; j < cast.expressions.size(); ++j) {
    face::Weights alone;
    alone.expressions.Push(j, 1);
    widest_m = std::max(widest_m, Drop_m(cast, alone));
  }
  for (const char* expression : {"surprised", "barking", "laugh"})
    EXPECT_LE(Drop_m(cast, Playing(cast, expression, 1)), 1.02F * widest_m) << expression;
}

TEST(Jaw, OpensSteadily) {
  const face::Cast& cast = DefaultCast();
  float before_m = 0;
  for (float open = 0; open <= 1; open += 0.125F) {
    const float drop_m = Drop_m(cast, Playing(cast, "smile", open));
    EXPECT_GE(drop_m, before_m);
    before_m = drop_m;
  }
}

TEST(Lids, HideTheBallsWhileAFaceTurnsIntoAnother) {
  const face::Cast& cast = DefaultCast();
  face::Composer composer(cast);
  for (std::uint16_t face = 1; face < cast.faces.size(); ++face) {
    for (const char* expression : {"neutral", "surprised", "sad"}) {
      face::Weights weights;
      weights.faces.Push(0, 0.5F);
      weights.faces.Push(face, 0.5F);
      weights.expressions.Push(ExpressionNamed(cast, expression), 1);
      weights.lids_shut = {1, 1};
      const auto& shape = composer.Compose(weights, face::Detail::kFine);
      const auto seen_m2 = inspect::BallsSeen_m2(shape, cast.topology.fine.triangles);
      EXPECT_EQ(seen_m2[0] + seen_m2[1], 0) << cast.faces[face].name << ", " << expression;
    }
  }
}

TEST(Faces, HaveNoFoldsHalfWayFromTheFirst) {
  const face::Cast& cast = DefaultCast();
  face::Composer composer(cast);
  for (std::uint16_t face = 1; face < cast.faces.size(); ++face) {
    std::vector<bool> skin;
    for (const char* expression : {"neutral", "smile", "angry", "sad", "laugh"}) {
      face::Weights weights;
      weights.faces.Push(0, 0.5F);
      weights.faces.Push(face, 0.5F);
      weights.expressions.Push(ExpressionNamed(cast, expression), 1);
      const auto& shape = composer.Compose(weights, face::Detail::kFine);
      if (skin.empty()) skin = inspect::FindSkin(shape, cast.topology.fine.triangles);
      EXPECT_TRUE(inspect::FindFolds(shape.fine, cast.topology.fine, skin).triangles.empty())
          << cast.faces[face].name << ", " << expression;
    }
  }
}

}  // namespace
}  // namespace kaori::tests
