// The performance: calls, fades, dials and scenes.
#include <cmath>
#include <map>
#include <random>

#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

TEST_F(PerformanceTest, OpensWithTheShowsFirstSceneWhole) {
  const auto& scene = Step();
  EXPECT_FLOAT_EQ(Weight(scene.weights.faces, 0), 1);
  EXPECT_FLOAT_EQ(Weight(scene.weights.expressions, 0), 1);
  EXPECT_FLOAT_EQ(scene.styles[static_cast<int>(scene::Style::kSoft)], 1);
}

TEST_F(PerformanceTest, AButtonFadesItsFaceInWithinTheFadeTime) {
  Push(3);
  Step();
  EXPECT_LT(Weight(performed_.scene.weights.faces, 3), 0.05F);
  Run(300ms);
  EXPECT_GT(Weight(performed_.scene.weights.faces, 3), 0.2F);
  EXPECT_LT(Weight(performed_.scene.weights.faces, 3), 0.8F);
  Run(400ms);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 3), 1);
  EXPECT_TRUE(performed_.lamps & (1U << 3U));
  EXPECT_FALSE(performed_.lamps & 1U);
}

TEST_F(PerformanceTest, AKeyCallsWhatAButtonMayCall) {
  constexpr std::uint8_t kKeyQ = 0x14;
  show_.keys = {{kKeyQ, {show::CallKind::kStyle, static_cast<std::uint16_t>(scene::Style::kWire)}}};
  Strike(kKeyQ);
  Run(1s);
  EXPECT_FLOAT_EQ(performed_.scene.styles[static_cast<int>(scene::Style::kWire)], 1);
}

TEST_F(PerformanceTest, TheFaceDialTakesTheCalledFaceBack) {
  Push(3);
  Run(1s);
  board_.surface.value.counts[0] -= board_.surface.value.counts_per_turn / 4;
  Run(500ms);
  EXPECT_NEAR(Weight(performed_.scene.weights.faces, 3), 0.75F, 0.01F);
  EXPECT_NEAR(Weight(performed_.scene.weights.faces, 0), 0.25F, 0.01F);
}

TEST_F(PerformanceTest, TheStrengthDialScalesTheExpressionAgainstNeutral) {
  Push(6);
  Run(1s);
  board_.surface.value.counts[2] -= board_.surface.value.counts_per_turn / 2;
  Run(500ms);
  EXPECT_NEAR(Weight(performed_.scene.weights.expressions, 1), 0.5F, 0.01F);
  EXPECT_NEAR(performed_.scene.weights.expressions.sum(), 1, 1e-5F);
}

TEST_F(PerformanceTest, AThousandRandomCallsNeverJump) {
  std::mt19937 random(7);
  std::map<int, float> before;
  constexpr float kFade_s = 0.4F;
  SetKnob(Knob::kFade, kFade_s);
  // Smoothstep is at most 1.5 times as fast as a straight fade.
  const float allowed = 1.5F * static_cast<float>(Seconds(kFrame)) / kFade_s + 1e-3F;
  float largest = 0;
  Step();
  for (int call = 0; call < 1000; ++call) {
    Push(static_cast<int>(random() % 21));
    for (unsigned frame = 0; frame < 1 + random() % 12; ++frame) {
      const auto weights = Step().weights;
      std::map<int, float> now;
      for (const auto& t : weights.faces) now[t.index] += t.weight;
      for (const auto& t : weights.expressions) now[100 + t.index] += t.weight;
      for (int i = 0; i < 120; ++i)
        if (!before.empty()) largest = std::max(largest, std::abs(now[i] - before[i]));
      EXPECT_NEAR(weights.faces.sum(), 1, 1e-4F);
      EXPECT_NEAR(weights.expressions.sum(), 1, 1e-4F);
      before = now;
    }
  }
  EXPECT_LE(largest, allowed);
  EXPECT_GT(largest, allowed / 4) << "nothing moved: the test saw no fade";
}

TEST_F(PerformanceTest, AFadeTimeOfZeroIsInstant) {
  SetKnob(Knob::kFade, 0);
  Push(2);
  EXPECT_FLOAT_EQ(Weight(Step().weights.faces, 2), 1);
}

TEST_F(PerformanceTest, ASceneChangesFaceExpressionStyleAndLightTogether) {
  Strike(kF1);
  Run(1s);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 4), 1);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.expressions, 3), 1);
  EXPECT_FLOAT_EQ(performed_.scene.styles[static_cast<int>(scene::Style::kFlat)], 1);
}

TEST_F(PerformanceTest, ASceneFadesItsBackdropInBeforeTheOldOne) {
  Strike(kF1);
  Run(400ms);
  const scene::Scene& amid = performed_.scene;
  EXPECT_EQ(amid.backdrop, show_.scenes[1].backdrop);
  float fading = 0;
  for (const scene::FadingBackdrop& f : amid.fading) {
    fading += f.weight;
    if (f.weight > 0) {
      EXPECT_EQ(f.backdrop, show_.scenes[0].backdrop);
    }
  }
  EXPECT_NEAR(fading, 0.5F, 0.1F);
  Run(1s);
  for (const scene::FadingBackdrop& f : performed_.scene.fading) EXPECT_EQ(f.weight, 0);
}

}  // namespace
}  // namespace kaori::performance
