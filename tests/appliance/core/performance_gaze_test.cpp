// Her gaze: saccades, whom she looks at, the head that follows, and operators who take it over.
#include <set>

#include "tests/appliance/core/life_fixture.h"

namespace kaori::performance {
namespace {

using Gaze = LifeTest;

constexpr int kFine_hz = 1000, kCoarse_hz = 50;

TEST_F(Gaze, IsSampledAtThePresentationOfEachFrameToAMillisecond) {
  const State start = state_;
  const Time began = now_;
  const auto fine = Trace(kFine_hz, 1, 120);
  state_ = start;
  now_ = began;
  const auto coarse = Trace(kCoarse_hz, 1, 120);
  float worst_ms = 0;
  int seen = 0;
  for (std::size_t n = 1; n + 1 < coarse.size(); ++n) {
    const std::size_t at = (n + 1) * (kFine_hz / kCoarse_hz) - 1;
    const glm::vec2 speed_rad_ms = (fine[at + 1] - fine[at - 1]) * 0.5F;
    if (glm::length(speed_rad_ms) < 0.1F * show::kDegree) continue;  // 100 degrees a second.
    worst_ms = std::max(worst_ms, glm::length(coarse[n] - fine[at]) / glm::length(speed_rad_ms));
    ++seen;
  }
  EXPECT_GT(seen, 60) << "frames within saccades";
  EXPECT_LE(worst_ms, 1);
  RecordProperty("saccade_error_ms", std::to_string(worst_ms));
}

// A saccade as it is seen at 1000 Hz.
struct Seen {
  double from_s = 0, length_s = 0;
  float amplitude_rad = 0;
};

std::vector<Seen> SaccadesOf(const std::vector<glm::vec2>& trace) {
  std::vector<Seen> all;
  for (std::size_t n = 1; n < trace.size(); ++n) {
    if (glm::length(trace[n] - trace[n - 1]) < 0.02F * show::kDegree)
      continue;  // Sway moves by a fiftieth of this.
    const std::size_t from = n - 1;
    while (n < trace.size() && glm::length(trace[n] - trace[n - 1]) >= 0.02F * show::kDegree) ++n;
    all.push_back({static_cast<double>(from) / kFine_hz, static_cast<double>(n - from) / kFine_hz,
                   glm::length(trace[n - 1] - trace[from])});
  }
  return all;
}

TEST_F(Gaze, FollowsTheMainSequenceAndRests200msBetweenSaccades) {
  const auto seen = SaccadesOf(Trace(kFine_hz, 1, 180));
  ASSERT_GT(seen.size(), 90U);
  for (std::size_t n = 0; n < seen.size(); ++n) {
    const double usual_s = SaccadeLength_s(seen[n].amplitude_rad);
    EXPECT_LE(seen[n].length_s, usual_s + 0.003);
    EXPECT_GE(seen[n].length_s, 0.55 * usual_s) << "level ends are too slow to be seen";
    if (n > 0) {
      EXPECT_GE(seen[n].from_s - seen[n - 1].from_s, 0.2) << n;
    }
  }
}

TEST_F(Gaze, IsAtSomebodyForSixtyPercentInBurstsOfTwoSecondsAndItsGlancesCanBeSeen) {
  std::vector<double> bursts;
  double at_s = 0, burst_s = 0, all_s = 0, stays_s = 0, longest_still_s = 0;
  std::vector<float> excursions_deg;
  float low = 1, high = -1;
  glm::vec3 rests(0);
  for (const Time end = now_ + 20min; now_ < end;) {
    Frame();
    const double frame_s = Seconds(kFrame);
    all_s += frame_s;
    const bool at = Off_rad(0, show_.gaze_targets[0].at_m) < show::kDegree;
    if (at) at_s += frame_s, burst_s += frame_s;
    if (!at && burst_s > 0.3) bursts.push_back(burst_s);
    if (!at) burst_s = 0;
    const float yaw = performed_.scene.gaze[0].yaw_rad;
    low = std::min(low, yaw), high = std::max(high, yaw);
    if (std::fmod(all_s, 20) < frame_s) {
      excursions_deg.push_back(Degrees(high - low));
      low = 1, high = -1;
    }
    // Something that an audience sees: a blink, a look elsewhere, a turn or a tilt of the head by half a degree.
    const scene::Head& head = performed_.scene.head;
    const glm::vec3 now(InStage(0) + glm::vec2(head.yaw_rad, head.pitch_rad), head.roll_rad);
    const bool moves =
        glm::length(now - rests) > 0.5F * show::kDegree || performed_.scene.weights.lids_shut[0] > 0.2F;
    stays_s = moves ? 0 : stays_s + frame_s;
    if (moves) rests = now;
    longest_still_s = std::max(longest_still_s, stays_s);
  }
  double mean_s = 0;
  for (const double burst : bursts) mean_s += burst / static_cast<double>(bursts.size());
  EXPECT_NEAR(at_s / all_s, 0.6, 0.06);
  EXPECT_NEAR(mean_s, 2.2, 0.3);
  std::ranges::sort(excursions_deg);
  EXPECT_GE(excursions_deg.front(), 6) << "in each 20 seconds";
  EXPECT_GE(excursions_deg[excursions_deg.size() / 2], 14) << "in most of them";
  EXPECT_LE(excursions_deg.back(), 45);
  EXPECT_LE(longest_still_s, 2);
  RecordProperty("solo_still_s", std::to_string(longest_still_s));
}

TEST_F(Gaze, OfEachEyeIsOnItsTargetWhereverTheHeadIsTurned) {
  CallLife(state_.life, {1, 0, 1, 1, 1});
  float worst_rad = 0;
  const auto look = [&](std::int32_t target, float x) {
    state_.life.target = target;
    board_.sticks[0].value = {.x = x, .y = x / 2, .twist = x, .slider = 0.5F};
    Run(2s);
    for (int frame = 0; frame < 60; ++frame) {
      Frame();
      for (const std::size_t eye : {0U, 1U})
        worst_rad =
            std::max(worst_rad, Off_rad(eye, show_.gaze_targets[static_cast<std::size_t>(target)].at_m));
    }
  };
  look(kWing, 0);  // So far aside that the head must follow.
  for (const std::int32_t target : {kVisitor, 0})
    for (const float x : {0.0F, 0.15F, -0.15F}) look(target, x);
  EXPECT_LE(Degrees(worst_rad), 0.5F);
  RecordProperty("gaze_target_error_deg", std::to_string(Degrees(worst_rad)));
  EXPECT_GT(performed_.scene.gaze[1].yaw_rad, performed_.scene.gaze[0].yaw_rad) << "they converge";
}

TEST_F(Gaze, HoldsItsGoalWhileAStickTurnsTheHead) {
  CallLife(state_.life, {1, 0.04F / 0.6F, 1, 1, 1});  // Glances too small to matter.
  Run(3s);
  float worst_rad = 0;
  for (int frame = 0; frame < 60; ++frame) {
    board_.sticks[0].value.x = 0.45F * std::sin(static_cast<float>(frame) / 10);  // 16 degrees to each side.
    Frame();
    worst_rad = std::max(worst_rad, Off_rad(0, state_.life.gaze.to_m));
  }
  EXPECT_LE(Degrees(worst_rad), 1);
  RecordProperty("gaze_hold_error_deg", std::to_string(Degrees(worst_rad)));
}

TEST_F(Gaze, GoesWithAHeadThatIsTurnedFarAndComesBackWithIt) {
  board_.sticks[0].value.x = 1;
  Run(1s);
  int strained = 0;
  for (int frame = 0; frame < 600; ++frame)
    strained += std::abs(Degrees(Frame().gaze[0].yaw_rad)) > 20.5F ? 1 : 0;
  EXPECT_LT(strained, 20) << "no eye stays in its corner";
  board_.sticks[0].value.x = 0;
  CallLife(state_.life, {0, 0.1F, 0, 0, 0});
  Run(5s);
  EXPECT_LT(Degrees(Off_rad(0, show_.gaze_targets[0].at_m)), 4);
}

TEST_F(Gaze, MovesTheHeadHalfOfTheWay40msLaterAndTheEyesAreThereFirst) {
  CallLife(state_.life, {0, 0, 1, 0, 0});
  state_.age_s = 0;
  Run(1s);
  state_.life.target = kWing;  // 34 degrees to her left.
  const float sway = performed_.scene.head.yaw_rad;
  for (int ms = 0; ms < 40; ++ms) Frame(1ms);
  EXPECT_NEAR(performed_.scene.head.yaw_rad, sway, 0.2F * show::kDegree);
  EXPECT_GT(Degrees(performed_.scene.gaze[0].yaw_rad), 10);
  Run(1s);
  const float wing = std::atan2(2.0F, 3.0F);
  EXPECT_NEAR(performed_.scene.head.yaw_rad, 0.5F * wing, 3 * show::kDegree);
  EXPECT_LT(Degrees(std::abs(performed_.scene.gaze[0].yaw_rad)), 20);
}

TEST_F(Gaze, IsTheSticksAsSoonAsItIsMovedAndNothingJumps) {
  Run(3s);
  board_.sticks[1].value.x = 0.5F;
  float before = performed_.scene.gaze[0].yaw_rad;
  for (int frame = 0; frame < 20; ++frame) {
    const float now = Frame().gaze[0].yaw_rad;
    EXPECT_LT(std::abs(now - before), 0.35F) << "the stick's own speed, and an ease";
    before = now;
  }
  for (int frame = 0; frame < 300; ++frame) EXPECT_EQ(Frame().gaze[0].yaw_rad, state_.gaze.yaw_rad);
  board_.sticks[1].value.x = 0;
  Run(500ms);
  EXPECT_EQ(performed_.scene.gaze[0].yaw_rad, state_.gaze.yaw_rad) << "the hand may only have paused";
  Run(4s);
  EXPECT_NE(performed_.scene.gaze[0].yaw_rad, performed_.scene.gaze[1].yaw_rad) << "her own eyes converge";
}

TEST_F(Gaze, IsOnACuesTargetEvenWithTheDialAtZeroAndStraightWhenNobodyIsNamed) {
  SetKnob(Knob::kLife, 0);
  Run(1s);
  EXPECT_EQ(performed_.scene.gaze[0].yaw_rad, 0);
  state_.life.target = kVisitor;
  Run(1s);
  EXPECT_LT(Degrees(Off_rad(0, show_.gaze_targets[kVisitor].at_m)), 0.5F);
  EXPECT_EQ(performed_.scene.head.yaw_rad, 0) << "the dial has the head";
  state_.life.target = show::kNoTarget;
  Run(1s);
  EXPECT_EQ(performed_.scene.gaze[0].yaw_rad, 0);
}

TEST_F(Gaze, IsTheSameEveryTimeAndRepeatsNothingInTenMinutes) {
  const State start = state_;
  const Time began = now_;
  std::vector<glm::vec3> goals;
  while (now_ < began + 11min) {
    Frame();
    if (goals.empty() || state_.life.gaze.to_m != goals.back()) goals.push_back(state_.life.gaze.to_m);
  }
  std::set<std::array<float, 6>> threes;
  for (std::size_t n = 0; n + 3 < goals.size(); n += 3)
    EXPECT_TRUE(
        threes
            .insert({goals[n].x, goals[n].y, goals[n + 1].x, goals[n + 1].y, goals[n + 2].x, goals[n + 2].y})
            .second)
        << n;
  const float last = performed_.scene.gaze[0].yaw_rad;
  state_ = start;
  now_ = began;
  while (now_ < began + 11min) Frame();
  EXPECT_EQ(performed_.scene.gaze[0].yaw_rad, last);
}

}  // namespace
}  // namespace kaori::performance
