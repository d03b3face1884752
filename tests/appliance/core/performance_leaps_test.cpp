// The performance: whatever the operators and their devices do, nothing that is seen jumps.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "appliance/core/performance/blink.h"
#include "appliance/core/performance/motions.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

constexpr float kFrame_s = 1.0F / 60;
constexpr float kSteepest = 1.5F;  // Of a smooth step, compared with a straight line.

// The largest step that any of the numbers took since the last look.
class Steps {
 public:
  void Look(const std::vector<float>& now) {
    for (std::size_t i = 0; i < now.size() && i < before_.size(); ++i)
      largest_ = std::max(largest_, std::abs(now[i] - before_[i]));
    before_ = now;
  }
  float largest() const { return largest_; }

 private:
  std::vector<float> before_;
  float largest_ = 0;
};

std::vector<float> ByIndex(const face::Terms& terms, std::size_t count) {
  std::vector<float> weights(count);
  for (const auto& t : terms) weights[t.index] += t.weight;
  return weights;
}

class Leaps : public PerformanceTest {
 protected:
  Leaps() {
    show_.cast.faces.resize(100);
    for (std::uint16_t i = 0; i < 68; ++i) {
      show::StageScene scene;
      scene.key_usage = static_cast<std::uint16_t>(0x50 + i);
      scene.fade_s = 3;
      scene.face = static_cast<std::uint16_t>(32 + i);
      show_.scenes.push_back(scene);
    }
    for (std::uint16_t i = 0; i < 9; ++i)  // Quickly there, and held.
      show_.motions.push_back(
          {.name = "hold",
           .key_usage = static_cast<std::uint16_t>(0xA0 + i),
           .curves = {{show::MotionTarget::kHeadYaw, 0, {{0, 0}, {0.05F, 0.3F}, {3, 0.3F}, {4, 0}}}}});
  }
};

// A colour that moves as the backdrops do.
glm::vec3 MeanBehind(const scene::Scene& scene) {
  glm::vec3 mean{};
  float rest = 1;
  for (const scene::FadingBackdrop& f : scene.fading) {
    mean += f.weight * f.backdrop.top;
    rest -= f.weight;
  }
  return mean + rest * scene.backdrop.top;
}

TEST_F(Leaps, AreNotMadeByButtonsDialsAndScenesInTheMiddleOfFades) {
  SetKnob(Knob::kFade, 0.8F);
  std::mt19937 random(3);
  Steps items, light, lids;
  for (int frame = 0; frame < 6000; ++frame) {
    if (random() % 8 == 0) Push(static_cast<int>(random() % 26));
    if (random() % 40 == 0) Strike(random() % 2 == 0 ? kF1 : kSpace);
    for (const std::size_t dial : {0U, 1U, 2U, 7U})
      if (random() % 4 == 0) board_.surface.value.counts[dial] += static_cast<int>(random() % 9) - 4;
    const scene::Scene& scene = Step();
    auto weights = ByIndex(scene.weights.faces, 100);
    const auto expressions = ByIndex(scene.weights.expressions, 20);
    weights.insert(weights.end(), expressions.begin() + 1, expressions.end());  // Neutral moves nothing.
    weights.insert(weights.end(), scene.styles.begin(), scene.styles.end());
    items.Look(weights);
    const glm::vec3 behind = MeanBehind(scene);
    light.Look({scene.light.exposure, behind.x, behind.z});
    lids.Look({scene.weights.lids_shut[0], scene.weights.lids_shut[1]});
    ASSERT_NEAR(scene.weights.faces.sum(), 1, 1e-4F);
    ASSERT_NEAR(scene.weights.expressions.sum(), 1, 1e-4F);
  }
  EXPECT_LE(items.largest(), kSteepest * kFrame_s / 0.8F * 1.4F + 0.02F);
  EXPECT_LE(light.largest(), 0.05F);
  EXPECT_LE(lids.largest(), kSteepest * kFrame_s / kBlinkShut_s + 1e-3F);
  EXPECT_GT(items.largest(), 0.01F) << "nothing moved: the test saw no fade";
  EXPECT_GT(lids.largest(), 0.1F) << "nobody blinked";
}

TEST_F(Leaps, AreNotMadeWhenMoreFacesAreCalledThanAMixtureHolds) {
  std::mt19937 random(4);
  Steps items;
  int most = 0;
  for (int frame = 0; frame < 6000; ++frame) {
    if (frame % 3 == 0) Strike(static_cast<std::uint8_t>(0x50 + random() % 68));
    const face::Terms& faces = Step().weights.faces;
    ASSERT_NEAR(faces.sum(), 1, 1e-4F);
    items.Look(ByIndex(faces, 100));
    most = std::max(most, faces.size());
  }
  EXPECT_EQ(most, face::Terms::kCapacity) << "the mixture was never full";
  EXPECT_LE(items.largest(), 1.0F / face::Terms::kCapacity + kSteepest * kFrame_s / 3);
}

TEST_F(Leaps, AreNotMadeByASceneKeyThatIsPressedAgainWhileItsSceneFades) {
  Step();
  Steps steps;
  for (int frame = 0; frame < 240; ++frame) {
    if (frame % 11 == 0 && frame < 60) Strike(kF1);
    const scene::Scene& scene = Step();
    steps.Look({Weight(scene.weights.faces, 4), Weight(scene.weights.expressions, 3), scene.styles[1]});
  }
  EXPECT_LE(steps.largest(), kSteepest * kFrame_s / 0.8F + 1e-3F);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 4), 1) << "the fade arrives all the same";
}

TEST_F(Leaps, AreNotMadeByMoreTakesThanThereAreVoices) {
  for (int frame = 0; frame < 30; ++frame)
    if (frame % 2 == 0) Strike(static_cast<std::uint8_t>(0xA0 + frame / 2 % 9)), Step();
  Run(6s);
  EXPECT_FLOAT_EQ(performed_.scene.head.yaw_rad, 0) << "every take ends";
}

TEST_F(Leaps, AreNotMadeByATakeThatWasCutOffWhenTheOtherEndsFirst) {
  show_.motions[1].curves[0].keys = {{0, 0}, {0.05F, 0.01F}, {0.1F, 0}};
  Strike(0xA5);
  Run(1s);
  EndMotion(state_, 6);
  Strike(0xA0);  // Ends after 0.1 s, before the one that fades out.
  Run(300ms);
  EXPECT_FLOAT_EQ(performed_.scene.head.yaw_rad, 0) << "what fades out does not stop half way";
}

TEST_F(Leaps, AreNotMadeWhenTheFifthTakeIsStruckAndFourPlay) {
  for (std::uint8_t key = 0xA0; key < 0xA4; ++key) Strike(key);
  for (int i = 0; i < 6; ++i) Step();
  const float before = performed_.scene.head.yaw_rad;
  show_.motions[5].curves[0].keys = {{0, 0}, {1, 0.01F}, {2, 0}};
  Strike(0xA4);
  EXPECT_GE(Step().head.yaw_rad, before - 4 * 0.3F * 4 * kFrame_s - 1e-3F);
}

TEST_F(Leaps, AreNotMadeByABlinkThatIsCalledForDuringABlink) {
  for (int between = 1; between < 20; ++between) {
    Steps lids;
    for (int frame = 0; frame < 120; ++frame) {
      if (frame % between == 0 && frame < 60) Strike(kSpace);
      lids.Look({Step().weights.lids_shut[0]});
    }
    EXPECT_LE(lids.largest(), kSteepest * kFrame_s / kBlinkShut_s + 1e-3F) << between;
    EXPECT_EQ(performed_.scene.weights.lids_shut[0], 0) << "and no lid sticks";
  }
}

TEST_F(Leaps, AreNotMadeWhenTheLipsAreLostInTheMiddleOfAWord) {
  board_.lips.source = board::SourceState::kLive;
  board_.lips.value = {.height = 0.85F, .width = 1.35F, .quality = 1};
  Run(500ms);
  Steps mouth;
  const auto look = [&](const scene::Scene& scene) { mouth.Look(ByIndex(scene.weights.channels, 20)); };
  look(performed_.scene);
  for (int frame = 0; frame < 120; ++frame) {
    if (frame == 10) board_.lips.value.quality = 0;
    if (frame == 40) board_.lips.value.quality = 1;
    if (frame == 70) board_.lips.source = board::SourceState::kStale;
    look(Step());
  }
  EXPECT_LE(mouth.largest(), 0.32F);  // A mouth that opens with its lips, 12 shares a second.
  EXPECT_EQ(performed_.scene.weights.mouth_given_away, 0);
  Steps given_back;
  board_.lips = {};
  board_.lips.source = board::SourceState::kLive;
  board_.lips.value = {.height = 0.85F, .width = 1.35F, .quality = 1};
  Run(500ms);
  board_.lips.value.quality = 0;
  for (int frame = 0; frame < 60; ++frame) given_back.Look(ByIndex(Step().weights.channels, 20));
  EXPECT_LE(given_back.largest(), kSteepest * 3 * kFrame_s + 1e-3F)
      << "the mouth falls shut before it is given back";
}

TEST_F(Leaps, AreNotMadeWhenAHandTakesTheMouthFromTheLips) {
  board_.lips.source = board::SourceState::kLive;
  board_.lips.value = {.height = 0.85F, .width = 1, .quality = 1};
  Run(500ms);
  Steps open;
  for (int frame = 0; frame < 60; ++frame) {
    if (frame == 1) board_.surface.value.counts[4] += 8;
    Step();
    open.Look({state_.mouth_open});
  }
  EXPECT_LE(open.largest(), 0.26F);
  EXPECT_LT(state_.mouth_open, 0.1F) << "the dial has it";
}

TEST_F(Leaps, AreNotMadeByASectionThatCannotBeRead) {
  for (int button = 0; button < 32; ++button) Push(button);
  board_.surface.value.counts.fill(5000);
  for (const std::uint8_t usage : {kSpace, kKey1, kF1}) Strike(usage);
  state_ = Opening(show_, board_, now_);
  SetKnob(Knob::kLife, 0);
  Step();
  const State before = state_;
  const board::Snapshot kept = board_;
  board_ = {};  // As board::ReadAll gives it.
  Run(200ms);
  board_ = kept;
  Run(200ms);
  EXPECT_EQ(state_.knobs, before.knobs);
  EXPECT_EQ(state_.faces.to, before.faces.to);
  EXPECT_EQ(state_.scene, before.scene);
  EXPECT_EQ(performed_.scene.weights.lids_shut[0], 0);
}

}  // namespace
}  // namespace kaori::performance
