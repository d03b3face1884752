// The lock: who is heard while it is on.
#include "appliance/core/performance/lock.h"

#include "appliance/core/board/keys.h"
#include "appliance/core/board/lines.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

using board::CallVerb;

class LockTest : public PerformanceTest {
 protected:
  LockTest() {
    show_.cue_list.cues.push_back({.number = "1", .scene = show::CueCall{1, 0.5F}, .lock = true});
    show_.cue_list.cues.push_back({.number = "2", .scene = show::CueCall{0, 0.5F}});
    show_.keys = {{board::key::kEnter, {show::CallKind::kCue, std::uint16_t(show::CueVerb::kGo)}},
                  {board::key::kA, {show::CallKind::kFace, 2}}};
    show::Track(show_);
    state_ = Opening(show_, board_, now_);
    Live();
    Step();
  }
  void Call(CallVerb verb, std::uint32_t subject, float value = 0) {
    Make({.verb = verb, .subject = subject, .value = value}, board::CallWriter::kControl);
    Step();
  }
  void LockIt() { Call(CallVerb::kLock, 1); }
  void ServiceKey(bool on) {
    board_.lines = {
        {.active = on ? 1U << unsigned(board::Line::kService) : 0}, now_, board::SourceState::kLive};
  }
};

TEST_F(LockTest, ComesOnByACallAndByACueAndGoesOffByTheServiceKeyAlone) {
  EXPECT_EQ(state_.locked, 0);
  LockIt();
  EXPECT_EQ(state_.locked, 1);
  Call(CallVerb::kLock, 0);
  EXPECT_EQ(state_.locked, 1) << "no call unlocks";
  EXPECT_EQ(state_.locked_out, 1U);
  ServiceKey(true);
  Step();
  EXPECT_EQ(state_.locked, 0);
  EXPECT_EQ(state_.locks_denied, 0U);
  LockIt();
  EXPECT_EQ(state_.locked, 0) << "somebody works at the box";
  EXPECT_EQ(state_.locks_denied, 1U);
  ServiceKey(false);
  CallCueByFoot();
  Run(100ms);
  EXPECT_EQ(state_.locked, 1) << "the cue locks";
}

TEST_F(LockTest, HearsNoStrayKeyAndStillGoes) {
  LockIt();
  Strike(board::key::kA);
  Strike(kKey1);
  Strike(kF1);
  board_.keys.value.down[kSpace / 32] |= 1U << kSpace % 32;
  Strike(kSpace);
  Run(500ms);
  EXPECT_EQ(state_.faces.to, 0);
  EXPECT_LT(state_.voices[0].motion, 0) << "no nod";
  EXPECT_EQ(state_.scene, 0);
  EXPECT_EQ(state_.lids_held[0], 0);
  EXPECT_EQ(state_.locked_out, 4U);
  Strike(board::key::kEnter);
  Run(100ms);
  EXPECT_EQ(state_.cue_run.active, 0) << "GO works";
  EXPECT_EQ(state_.locked_out, 4U);
}

TEST_F(LockTest, RefusesJumpsLevelsFromAfarAndRolesThatAreMoved) {
  LockIt();
  Call(CallVerb::kGoTo, board::CueKey("2"));
  Call(CallVerb::kStandBy, board::CueKey("2"));
  Call(CallVerb::kLevel, std::uint32_t(show::Level::kHeadYaw), 0.5F);
  Call(CallVerb::kLetGo, std::uint32_t(show::Level::kHeadYaw));
  Call(CallVerb::kLoadRole, 1, kNoDevice);
  Call(CallVerb::kCue, std::uint32_t(show::CueVerb::kPause));
  EXPECT_EQ(state_.locked_out, 6U);
  EXPECT_EQ(state_.cue_run.active, -1);
  EXPECT_EQ(state_.cue_run.standby, 0);
  EXPECT_EQ(state_.cue_run.paused, 0U);
  EXPECT_NE(state_.role_devices[1], kNoDevice);
  EXPECT_EQ(state_.levels[std::size_t(show::Level::kHeadYaw)].owner, Owner::kRest);
  EXPECT_EQ(state_.calls_refused, 0U) << "the show has all of them";
}

TEST_F(LockTest, HearsGoBackPanicAndBlackoutAndTheControlsOfThoseWhoPlay) {
  LockIt();
  Call(CallVerb::kCue, std::uint32_t(show::CueVerb::kBlackout));
  EXPECT_EQ(state_.black_called, 1);
  Call(CallVerb::kCue, std::uint32_t(show::CueVerb::kPanic));
  EXPECT_EQ(state_.cue_run.panicking, 1U);
  board_.sticks[0].value.x = 0.8F;
  Push(3);
  Run(1s);
  EXPECT_GT(std::abs(state_.head.yaw_rad), 0.1F);
  EXPECT_EQ(state_.faces.to, 3) << "a role is played from the dial box";
  EXPECT_EQ(state_.locked_out, 0U);
}

TEST_F(LockTest, RefusesButtonsOfADialBoxThatNobodyPlaysAndBlinksTheirLamp) {
  for (auto& device : state_.role_devices)
    if (device == std::uint8_t(show::Device::kDialBox)) device = kNoDevice;
  LockIt();
  Push(3);
  Step();
  EXPECT_EQ(state_.faces.to, 0);
  EXPECT_EQ(state_.locked_out, 1U);
  int changes = 0;
  bool lit = false;
  for (Duration t{}; t < 1s; t += kFrame) {
    const bool now = (performed_.lamps >> 3U & 1U) != 0;
    changes += now != lit ? 1 : 0;
    lit = now;
    Step();
  }
  EXPECT_EQ(changes, 4) << "twice on and off";
}

}  // namespace
}  // namespace kaori::performance
