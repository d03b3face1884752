// A GO is never lost, whenever the stage dies.
#include <random>

#include <gtest/gtest.h>

#include "appliance/core/board/lines.h"
#include "appliance/core/board/performance_state.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/pack.h"
#include "tests/appliance/core/many_cues.h"
#include "tests/system/programs_fixture.h"

namespace kaori::test {
namespace {

using std::chrono::milliseconds;

constexpr int kKills = 40;
constexpr std::uint8_t kEnter = 0x28;

class GoOverKills : public HeldControls {
 protected:
  GoOverKills() {
    const show::Show show = tests::WithManyCues(show::LoadPack(Pack()).value(), 50);
    EXPECT_TRUE(show::SavePack(show, programs_.File("list.kaori")));
    Start("kaori-input");
    StartStage();
  }

  void StartStage() {
    programs_.Start("kaori-stage", {"--links", programs_.links(), "--board", programs_.board(), "--pack",
                                    programs_.File("list.kaori")});
  }

  // GOs that the performance has answered.
  struct Answered {
    std::uint32_t played = 0, refused = 0;
    std::int32_t active = -1;
  };
  Answered Now() const {
    const auto state = board::Restore<performance::State>(board_.Read<board::Performance>().value);
    if (!state) return {};
    return {state->cue_run.played, state->cue_run.refused, state->cue_run.active};
  }

  // By the foot switch, or by its key: down, until the driver has heard it.
  bool Press(bool foot) {
    const auto pushes = [&] {
      return foot ? board_.Read<board::Lines>().value.pushes[static_cast<std::size_t>(board::Line::kGo)]
                  : board_.Read<board::Keys>().value.pushes[kEnter];
    };
    const std::uint32_t before = pushes();
    foot ? rig_->lines().Close(0) : rig_->keyboard().Press(kEnter);
    return Await([&] { return Between() && pushes() != before; });
  }
  void LetUp(bool foot) { foot ? rig_->lines().Open(0) : rig_->keyboard().Release(kEnter); }
};

// Half of them are pressed while no stage runs, the others in the last frames of one that dies. Every second one comes by foot.
TEST_F(GoOverKills, IsPlayedOnceThoughTheStageIsKilledFortyTimes) {
  ASSERT_TRUE(Await(
      [&] { return Between() && rig_->connected("lines") && rig_->connected("keyboard") && frames() > 0; },
      std::chrono::seconds(30)))
      << programs_.LogOf("kaori-stage");
  std::mt19937 random(40);
  int lost = 0;
  for (int kill = 0; kill < kKills; ++kill) {
    SCOPED_TRACE("kill " + std::to_string(kill));
    const bool foot = kill % 2 == 0, dead = kill % 4 < 2;
    if (dead) programs_.Kill("kaori-stage");
    const Answered before = Now();
    ASSERT_TRUE(Press(foot)) << programs_.LogOf("kaori-input");
    if (!dead) {
      Hold(std::chrono::microseconds(random() % 70'000));
      programs_.Kill("kaori-stage");
    }
    LetUp(foot);
    Hold(milliseconds(30));
    const std::uint32_t frames_then = frames();
    StartStage();
    ASSERT_TRUE(Await([&] { return Between() && frames() > frames_then + 2; }, std::chrono::seconds(30)))
        << programs_.LogOf("kaori-stage");
    const Answered now = Now();
    EXPECT_EQ(now.played, before.played + 1);
    EXPECT_EQ(now.refused, before.refused);
    EXPECT_EQ(now.active, before.active + 1);
    lost += now.played == before.played ? 1 : 0;
    Hold(milliseconds(350));  // Longer than the guard of GO.
  }
  EXPECT_EQ(lost, 0);
  RecordProperty("go_lost_over_kills", lost);
  RecordProperty("go_kills", kKills);
}

}  // namespace
}  // namespace kaori::test
