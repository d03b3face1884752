// The voice takes a mouth whose lips are lost, gives it back, and never beats the dial.
#include <algorithm>
#include <cmath>
#include <vector>

#include "appliance/core/performance/mouth.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

using board::SourceState;

constexpr float kVoiceFrame_s = 1.0F / 60;
constexpr float kFastest_per_s = 15;  // No mouth opens faster, and
constexpr float kMotions_per_s = 18;  // an expression's own mouth gives way so fast.

// An operator whose lips, camera and microphone a test moves. Cameras speak 30 times a second and are 30 ms
// late, voices 200 times and 12 ms.
class VoiceInTheMouth : public PerformanceTest {
 protected:
  void CameraSees(float open) {
    camera_ = true;
    lips_open_ = open;
  }
  void Says(float open) {
    microphone_ = true;
    voice_open_ = open;
  }
  const scene::Scene& Frame() {
    const Time light = now_ + kFrame;
    const auto sampled = [&](Duration period, Duration late) {
      return Time{} + (light - late).time_since_epoch() / period * period;
    };
    if (camera_) {
      board_.lips.at = sampled(33'333'333ns, 30ms);
      board_.lips.source = SourceState::kLive;
      board_.lips.value = {.height = 0.28F + lips_open_ * 0.57F, .width = 1, .quality = quality_};
    }
    if (microphone_) {
      board_.voice.at = sampled(5ms, 12ms);
      board_.voice.source = SourceState::kLive;
      board_.voice.value = {.level_db = -20, .speaking = 1, .height = voice_open_, .quality = 1};
    }
    return Step();
  }
  // Runs, and tells the steepest that any mouth shape moved, in weights a second.
  float Steepest(Duration time) {
    float steepest = 0;
    for (const Time end = now_ + time; now_ < end;) {
      const std::vector<float> before = Shapes();
      Frame();
      const std::vector<float> after = Shapes();
      for (std::size_t n = 0; n < before.size(); ++n)
        steepest = std::max(steepest, std::abs(after[n] - before[n]) / kVoiceFrame_s);
    }
    return steepest;
  }
  std::vector<float> Shapes() const {
    std::vector<float> shapes;
    for (int shape = 11; shape <= 14; ++shape)
      shapes.push_back(Weight(performed_.scene.weights.channels, shape));
    return shapes;
  }
  float Open() const { return Shapes()[2] + Shapes()[3]; }

  bool camera_ = false, microphone_ = false;
  float lips_open_ = 0, voice_open_ = 0, quality_ = 1;
};

TEST_F(VoiceInTheMouth, MovesItWithoutACamera) {
  Says(0.8F);
  Steepest(300ms);
  EXPECT_NEAR(Open(), 0.8F, 0.03F);
  EXPECT_NEAR(performed_.scene.weights.mouth_given_away, 1, 1e-3F);
  Says(0);
  Steepest(2s);
  EXPECT_NEAR(performed_.scene.weights.mouth_given_away, 0, 1e-3F)
      << "silent, the expression has its own mouth";
}

TEST_F(VoiceInTheMouth, IsNotHeardWhileTheLipsAreSeen) {
  CameraSees(0.3F);
  Says(1);
  Steepest(1s);
  EXPECT_NEAR(Open(), 0.3F, 0.02F);
}

struct Loss {
  const char* name;
  void (*lose)(bool& camera, float& quality, board::Stamped<board::Lips>& lips);
  friend void PrintTo(const Loss& loss, std::ostream* out) { *out << loss.name; }
};
const Loss kLosses[] = {
    {"ThePaintIsCovered", [](bool&, float& quality, auto&) { quality = 0; }},
    {"TheCameraStalls", [](bool& camera, float&, auto&) { camera = false; }},
    {"TheCameraIsPulled",
     [](bool& camera, float&, auto& lips) {
       camera = false;
       lips.source = SourceState::kStale;
     }},
};

class LipsThatAreLost : public VoiceInTheMouth, public ::testing::WithParamInterface<Loss> {};

TEST_P(LipsThatAreLost, AreReplacedByTheVoiceWithin200MsWithoutAJump) {
  CameraSees(0.1F);
  Says(0.9F);
  Steepest(1s);
  const float before = Open();
  const Time lost = board_.lips.at;  // When they were seen last.
  GetParam().lose(camera_, quality_, board_.lips);
  float steepest = 0;
  Time moved{}, arrived{};
  while (now_ - lost < 600ms) {
    steepest = std::max(steepest, Steepest(1ns));
    if (moved == Time{} && Open() > before + 0.1F) moved = now_;
    if (arrived == Time{} && Open() > before + 0.75F * (0.9F - before)) arrived = now_;
  }
  ASSERT_NE(arrived, Time{});
  RecordProperty("moved_ms", static_cast<int>((moved - lost) / 1ms));
  RecordProperty("arrived_ms", static_cast<int>((arrived - lost) / 1ms));
  EXPECT_LE(moved - lost, 200ms);
  EXPECT_LE(arrived - lost, 220ms);
  EXPECT_LE(steepest, kFastest_per_s + 0.5F);
}

TEST_P(LipsThatAreLost, GetTheMouthBackTheSameWay) {
  CameraSees(0.1F);
  Says(0.9F);
  Steepest(1s);
  GetParam().lose(camera_, quality_, board_.lips);
  Steepest(1s);
  EXPECT_NEAR(Open(), 0.9F, 0.03F);
  camera_ = true;
  quality_ = 1;
  EXPECT_LE(Steepest(200ms), kFastest_per_s + 0.5F);
  EXPECT_NEAR(Open(), 0.1F, 0.03F);
}

TEST_P(LipsThatAreLost, LeaveTheMouthToTheExpressionWhenThereIsNoVoiceEither) {
  CameraSees(0.7F);
  Steepest(1s);
  GetParam().lose(camera_, quality_, board_.lips);
  board_.lips.source = SourceState::kStale;  // The lips program says so after 200 ms.
  camera_ = false;
  EXPECT_LE(Steepest(1s), kMotions_per_s);
  EXPECT_EQ(performed_.scene.weights.mouth_given_away, 0);
}

INSTANTIATE_TEST_SUITE_P(When, LipsThatAreLost, ::testing::ValuesIn(kLosses),
                         [](const auto& tested) { return tested.param.name; });

TEST_F(VoiceInTheMouth, ComesToRestWhenTheMicrophoneIsPulled) {
  Says(0.9F);
  Steepest(1s);
  microphone_ = false;
  board_.voice.source = SourceState::kStale;
  EXPECT_LE(Steepest(1s), kMotions_per_s);
  EXPECT_EQ(performed_.scene.weights.mouth_given_away, 0);
}

TEST_F(VoiceInTheMouth, GivesWayToAHandOnTheDialAsTheLipsDo) {
  for (const bool camera : {false, true}) {
    if (camera) CameraSees(0.9F);
    Says(0.9F);
    SetKnob(Knob::kMouth, 0);
    Steepest(1s);
    board_.surface.value.counts[4] += 50;
    EXPECT_LE(Steepest(1s), kFastest_per_s + 0.5F);
    EXPECT_NEAR(Open(), state_.shown[static_cast<std::size_t>(Knob::kMouth)], 0.02F);
    EXPECT_LT(Open(), 0.5F);
  }
}

TEST_F(VoiceInTheMouth, MakesTheMouthALittleLaterThanTheLipsDo) {
  CameraSees(0.5F);
  Steepest(500ms);
  const Duration lips = MouthLag(state_, kFrame);
  EXPECT_GT(lips, 8ms);
  camera_ = false;
  Says(0.5F);
  Steepest(500ms);
  EXPECT_GT(MouthLag(state_, kFrame), lips);
  EXPECT_LT(MouthLag(state_, kFrame), 50ms);
}

}  // namespace
}  // namespace kaori::performance
