// The performance: clocks that leap, days of playing, and states that another stage left behind.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

using Clocks = PerformanceTest;

TEST_F(Clocks, ThatGoBackALittleHoldHerStillAndNothingIsPlayedTwice) {
  Push(3);
  Run(300ms);
  const float there = Weight(performed_.scene.weights.faces, 3);
  for (int i = 0; i < 10; ++i) {  // As when screens come and go: back by a frame, and forward again.
    Step(-kFrame);
    EXPECT_EQ(Weight(performed_.scene.weights.faces, 3), there);
    Step(kFrame);
    EXPECT_EQ(Weight(performed_.scene.weights.faces, 3), there);
  }
  Step();
  EXPECT_GT(Weight(performed_.scene.weights.faces, 3), there);
}

TEST_F(Clocks, ThatBeginAnewAreFollowed) {
  Push(3);
  Step();
  now_ = Time{} + 1s;  // A machine that was started again, with a board that was kept.
  Step();
  Run(1s);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 3), 1);
}

TEST_F(Clocks, ThatLeapToTheirEndsAreOneStep) {
  Push(3);
  Step();
  for (const Time last : {Time::min(), Time::max()}) {
    state_.last = last;
    const float before = Weight(performed_.scene.weights.faces, 3);
    Step();
    EXPECT_LT(Weight(performed_.scene.weights.faces, 3), before + 0.3F);
  }
  Run(1s);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 3), 1);
}

TEST_F(Clocks, ThatRunForDaysLetHerBreatheOnEvenly) {
  SetKnob(Knob::kLife, 1);
  state_.age_s = kLifePeriod_s - 2;
  float largest = 0;
  float before = Step().breath;
  const float yaw_before = performed_.scene.head.yaw_rad;
  for (const Time end = now_ + 4s; now_ < end;) {
    const float breath = Step().breath;
    EXPECT_NE(breath, before);
    largest = std::max(largest, std::abs(breath - before));
    before = breath;
  }
  EXPECT_LT(largest, 6.3F * 0.23F / 60 / (2 * 0.4F) * 1.05F)
      << "in the part of its time that breathing in takes";
  EXPECT_NE(performed_.scene.head.yaw_rad, yaw_before);
  EXPECT_LT(state_.age_s, 3) << "the waves began anew, or a float would count on until a frame is lost in it";
}

TEST(AShowWithoutScenes, OpensWithItsFirstFaceAndAnswersItsButtons) {
  show::Show show = SmallShow();
  show.scenes.clear();
  board::Snapshot board;
  Time now = Time{} + 5s;
  State state = Opening(show, board, now);
  board.surface.source = board.keys.source = board::SourceState::kLive;
  board::NotePress(board.surface.value, 2, now);
  for (std::size_t usage = 0; usage < 256; usage += 9) board::NotePress(board.keys.value, usage, now);
  Performed performed;
  for (int i = 0; i < 90; ++i) {
    const InputEvents events = ReadEvents(state.seen, board);
    performed = Animate(state, board, events, show, now += kFrame);
    state = performed.state;
  }
  EXPECT_EQ(performed.lamps & 0x1FU, 1U << 2U);
  EXPECT_EQ(performed.scene.weights.faces.size(), 1);
  EXPECT_TRUE(IsValid(state, show));
}

struct Spoiled {
  const char* name;
  void (*spoil)(State&);
  friend void PrintTo(const Spoiled& s, std::ostream* out) { *out << s.name; }
};
const Spoiled kSpoiled[] = {
    {"ALidThatIsFarTooShut", [](State& s) { s.lids_held[1] = 900; }},
    {"ABlinkLongBeforeItBegins", [](State& s) { s.blink_s[0] = -900; }},
    {"AFadeLongBeforeItBegins", [](State& s) { s.faces.progress = -500; }},
    {"AFadeThatNeverEnds", [](State& s) { s.styles.duration_s = 1e9F; }},
    {"WeightsThatCancelOut",
     [](State& s) { (s.faces.from.clear(), s.faces.from.Push(1, 900), s.faces.from.Push(2, -899)); }},
    {"AStyleThatDoesNotExist", [](State& s) { s.styles.to = 5; }},
    {"ALightBeyondTheLamp", [](State& s) { s.exposure.to = 900; }},
    {"ABackdropOfNoScene", [](State& s) { s.backdrops.to = 900; }},
    {"AKnobBeyondItsEnd", [](State& s) { s.shown[2] = 90; }},
    {"ALossThatIsNoTime", [](State& s) { s.sticks[1].lost_s = kNan; }},
    {"AStickTooPresent", [](State& s) { s.sticks[0].presence = 2; }},
    {"ATakeThatBeginsTomorrow",
     [](State& s) {
       s.voices[0] = {0, -900, 1};
     }},
    {"AMotionThatDoesNotExist", [](State& s) { s.voices[3].motion = 1; }},
    {"ATakeTooLoud",
     [](State& s) {
       s.voices[0] = {0, 0, 90};
     }},
    {"ASceneThatDoesNotExist", [](State& s) { s.scene = 2; }},
    {"AnAgeThatIsNone", [](State& s) { s.age_s = -1; }},
    {"HairThatIsNowhere", [](State& s) { s.sway[1].speed_rad_s.x = kNan; }},
    {"AnEarThatIsNowhere", [](State& s) { s.chains[1].lower.angle_rad.y = kNan; }},
    {"AMouthThatIsMoreThanTheVoices", [](State& s) { s.mouth_voice = 2; }},
    {"LipsThatWereLostNever", [](State& s) { s.lips_lost_s = kNan; }},
    {"ALookAtNowhere", [](State& s) { s.life.gaze.to_m.z = kNan; }},
    {"ALookAtNobodyWhoIsThere", [](State& s) { s.life.target = 3; }},
    {"LifeThatIsTooMuch", [](State& s) { s.life.now[1] = 90; }},
    {"LifeThatNeverBlinks", [](State& s) { s.life.blinks.to_next = 900; }},
};

class AnUnsoundState : public PerformanceTest, public ::testing::WithParamInterface<Spoiled> {};

TEST_P(AnUnsoundState, IsNotGoneOnWith) {
  Push(3);
  Run(100ms);
  ASSERT_TRUE(IsValid(state_, show_));
  GetParam().spoil(state_);
  EXPECT_FALSE(IsValid(state_, show_));
}

INSTANTIATE_TEST_SUITE_P(Each, AnUnsoundState, ::testing::ValuesIn(kSpoiled),
                         [](const auto& spoiled) { return std::string(spoiled.param.name); });

bool IsPlayable(const scene::Scene& scene, const show::Show& show) {
  const auto exist = [](const face::Terms& terms, std::size_t count) {
    return std::all_of(terms.begin(), terms.end(),
                       [count](const face::Term& t) { return t.index < count && std::isfinite(t.weight); });
  };
  float all = scene.head.yaw_rad + scene.head.pitch_rad + scene.head.roll_rad + scene.gaze[0].yaw_rad +
              scene.breath + scene.hair_sway_rad[1].x + scene.light.exposure + scene.backdrop.top.x +
              scene.weights.mouth_given_away;
  for (const float style : scene.styles) all += style;
  return std::isfinite(all) && exist(scene.weights.faces, show.cast.faces.size()) &&
         exist(scene.weights.expressions, show.cast.expressions.size()) &&
         exist(scene.weights.channels, show.cast.expressions.size());
}

TEST_F(PerformanceTest, AnyBytesOnTheBoardAreRefusedOrPlayWell) {
  Push(3);
  Strike(kKey1);
  Run(100ms);
  const State sound = state_;
  std::mt19937 random(5);
  int taken = 0;
  for (int round = 0; round < 3000; ++round) {
    state_ = sound;
    auto* bytes = reinterpret_cast<std::uint8_t*>(&state_);
    for (int flips = 0; flips < 3; ++flips)
      bytes[random() % sizeof(State)] = static_cast<std::uint8_t>(random());
    if (!IsValid(state_, show_)) continue;
    ++taken;
    for (int frame = 0; frame < 20; ++frame) ASSERT_TRUE(IsPlayable(Step(), show_));
    ASSERT_TRUE(IsValid(state_, show_)) << "a sound state goes on into a sound state";
  }
  EXPECT_GT(taken, 100);
  EXPECT_LT(taken, 3000);
}

}  // namespace
}  // namespace kaori::performance
