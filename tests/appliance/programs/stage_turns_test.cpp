// How long a stage may be silent before it is taken for one that hangs: by the time that its frames take.
#include <gtest/gtest.h>

#include "appliance/programs/stage/stage.h"
#include "drivers/base/service.h"
#include "tests/appliance/core/pack_fixture.h"
#include "tests/appliance/programs/stage_screen.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.

constexpr int kKnowsItsPace = 100;  // Frames.

class StageTurns : public PackTest {
 protected:
  StageTurns()
      : board_(board::Board::Create((folder_ / "board").string()).value()),
        studio_(stage::Studio::Open(SmallShow()).value()),
        stage_(board_, stage::StageWriters::Acquire(board_).value(), *studio_, clock_) {
    screen_.clock = &clock_;
    stage_.SetScreen(std::make_unique<HeldScreen>(screen_));
  }

  void Draw(int frames, Duration each) {
    screen_.takes = each;
    for (int n = 0; n < frames; ++n) {
      clock_.Advance(1ms);
      screen_.flip = ports::Flip{clock_.now(), screen_.presented, 1ms};
      stage_.Step();
    }
  }
  // After which the service manager ends it, before what its unit allows.
  double limit_s() const { return Seconds(stage_.usual_turn() * service::Watchdog::kPatientTurns); }

  ManualClock clock_;
  board::Board board_;
  std::unique_ptr<stage::Studio> studio_;
  ScreenHand screen_;
  stage::Stage stage_;
};

TEST_F(StageTurns, AreNotKnownBeforeTheFirst) {
  EXPECT_EQ(limit_s(), 0);
}

TEST_F(StageTurns, OfAMachineThatDrawsFifteenPicturesASecondAllowTenSecondsAtFirst) {
  for (int frame = 1; frame < kKnowsItsPace; ++frame) {
    Draw(1, 66ms);
    ASSERT_NEAR(limit_s(), 10, 0.001) << frame;
  }
}

TEST_F(StageTurns, AllowTwentyOfTheSlowestSoFarAtFirst) {
  Draw(1, 700ms);
  EXPECT_NEAR(limit_s(), 14, 0.001);
  Draw(1, 2s);
  EXPECT_NEAR(limit_s(), 40, 0.001);
  Draw(kKnowsItsPace - 3, 20ms);
  EXPECT_NEAR(limit_s(), 40, 0.001);
}

TEST_F(StageTurns, AllowThirtyUsualOnesOnceThePaceIsKnown) {
  Draw(1, 2s);
  Draw(kKnowsItsPace, 66ms);
  EXPECT_NEAR(limit_s(), 1.98, 0.001);
}

TEST_F(StageTurns, NeverAllowMoreThanTwentyOfTheSlowest) {
  Draw(kKnowsItsPace + 20, 1s);
  EXPECT_NEAR(limit_s(), 20, 0.001) << "thirty usual ones are more";
  Draw(40, 3s);
  EXPECT_NEAR(limit_s(), 60, 0.001) << "a machine that has become slower is not ended for it";
}

}  // namespace
}  // namespace kaori::tests
