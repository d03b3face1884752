// The performance: GO and blackout by GPIO lines.
#include <cmath>

#include "appliance/core/board/lines.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

using board::Line;
using board::SourceState;

class LinesTest : public PerformanceTest {
 protected:
  LinesTest() {
    show_.scenes.resize(3);
    show_.scenes[2] = show_.scenes[0];
    show::Track(show_);
    Come();
  }
  void Come() { board_.lines.source = SourceState::kLive; }
  void Switch(Line line, bool on) {
    auto& lines = board_.lines.value;
    const unsigned bit = 1U << static_cast<unsigned>(line);
    const bool pushed = on && (lines.active & bit) == 0;
    if (pushed) ++lines.pushes[static_cast<std::size_t>(line)];
    if (pushed && line == Line::kGo) CallCueByFoot();
    lines.active = on ? lines.active | bit : lines.active & ~bit;
  }
  void Tread() {
    Switch(Line::kGo, true);
    Run(50ms);
    Switch(Line::kGo, false);
    Run(50ms);
  }
  float Exposure() const { return performed_.scene.light.exposure; }
};

TEST_F(LinesTest, BlackoutFadesToBlackWithinHalfASecondAndBackAndNeverJumps) {
  Run(1s);
  for (const bool black : {true, false}) {
    Switch(Line::kBlackout, black);
    float before = Exposure();
    for (Duration t{}; t < 500ms; t += kFrame) {
      Step();
      EXPECT_LE(std::abs(Exposure() - before), 0.08F) << Seconds(t);
      before = Exposure();
    }
    EXPECT_FLOAT_EQ(Exposure(), black ? 0.0F : 1.0F);
  }
}

TEST_F(LinesTest, ASwitchThatIsTurnedBackHalfWayTurnsTheFadeBack) {
  Run(1s);
  Switch(Line::kBlackout, true);
  Run(200ms);
  const float half = Exposure();
  EXPECT_GT(half, 0.2F);
  EXPECT_LT(half, 0.8F);
  Switch(Line::kBlackout, false);
  EXPECT_NEAR(Step().light.exposure, half, 0.08F);
  Run(300ms);
  EXPECT_FLOAT_EQ(Exposure(), 1);
}

TEST_F(LinesTest, InputIsUsedBeneathABlackout) {
  Run(1s);
  Switch(Line::kBlackout, true);
  Run(500ms);
  Push(3);
  Run(1s);
  EXPECT_FLOAT_EQ(Exposure(), 0) << "a call lights nothing";
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 3), 1);
  Switch(Line::kBlackout, false);
  Run(500ms);
  EXPECT_FLOAT_EQ(Exposure(), 1);
}

TEST_F(LinesTest, ALostLineHoldsABlackoutUntilASceneIsCalled) {
  Switch(Line::kBlackout, true);
  Run(1s);
  board_.lines = {.value = {.active = 0, .pushes = board_.lines.value.pushes}, .source = SourceState::kStale};
  Run(5s);
  EXPECT_FLOAT_EQ(Exposure(), 0);
  Strike(kF1);
  Run(1s);
  EXPECT_GT(Exposure(), 0.9F);
}

TEST_F(LinesTest, NoLinesAreNoBlackout) {
  board_.lines = {.value = {.active = 0xFFFFFFFF}, .source = SourceState::kAbsent};
  board_.lines.value.pushes.fill(9);
  Run(1s);
  EXPECT_FLOAT_EQ(Exposure(), 1);
  EXPECT_EQ(state_.scene, 0);
}

TEST_F(LinesTest, AStageThatStartsInABlackoutIsBlackFromItsFirstFrame) {
  Switch(Line::kBlackout, true);
  Switch(Line::kGo, true);
  state_ = Opening(show_, board_, now_);
  EXPECT_FLOAT_EQ(Step().light.exposure, 0);
  EXPECT_EQ(state_.scene, 0) << "what was pushed before is not pushed now";
}

TEST_F(LinesTest, GoCallsTheNextSceneAndAfterTheLastNone) {
  Tread();
  Run(1s);
  EXPECT_EQ(state_.scene, 1);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 4), 1) << "the scene's own face";
  for (const int scene : {2, 2}) {
    Tread();
    EXPECT_EQ(state_.scene, scene) << "a slip after the end does not open the show again";
    Run(1s);
  }
}

TEST_F(LinesTest, GoGoesOnFromASceneThatAKeyCalled) {
  Strike(kF1);
  Run(1s);
  ASSERT_EQ(state_.scene, 1);
  Tread();
  EXPECT_EQ(state_.scene, 2);
}

TEST_F(LinesTest, ASecondGoWithinThreeTenthsOfASecondIsASlip) {
  Tread();
  Tread();
  EXPECT_EQ(state_.scene, 1);
  Run(300ms);
  Tread();
  EXPECT_EQ(state_.scene, 2);
}

TEST_F(LinesTest, AGoAfterAQuarterOfASecondIsASlipAndAfterAThirdIsNone) {
  const auto go_after = [this](int frames) {
    Switch(Line::kGo, false);
    for (int i = 1; i < frames; ++i) Step();
    Switch(Line::kGo, true);
    Step();
    return state_.scene;
  };
  ASSERT_EQ(go_after(1), 1);
  EXPECT_EQ(go_after(15), 1) << "0.25 s";
  EXPECT_EQ(go_after(5), 2) << "0.33 s since the one that called";
}

TEST_F(LinesTest, LettingGoOfTheFootSwitchCallsNothing) {
  Switch(Line::kGo, true);
  Run(2s);
  ASSERT_EQ(state_.scene, 1);
  Switch(Line::kGo, false);
  Run(2s);
  EXPECT_EQ(state_.scene, 1);
}

TEST_F(LinesTest, PresenceAndServiceMoveNothing) {
  Run(1s);
  const scene::Scene before = performed_.scene;
  Switch(Line::kPresence, true);
  Switch(Line::kService, true);
  Run(500ms);
  EXPECT_EQ(performed_.scene.light.exposure, before.light.exposure);
  EXPECT_EQ(state_.scene, 0);
}

TEST_F(LinesTest, AShowWithoutScenesHearsNoGo) {
  show_.scenes.clear();
  state_ = Opening(show_, board_, now_);
  Tread();
  EXPECT_TRUE(IsValid(state_, show_));
}

}  // namespace
}  // namespace kaori::performance
