// A performance whose sixth cue is the lobby.
#pragma once

#include "appliance/core/board/lines.h"
#include "appliance/core/performance/lobby.h"
#include "appliance/core/performance/motions.h"
#include "tests/appliance/core/cues_fixture.h"

namespace kaori::performance {

inline constexpr std::int32_t kTuesdayEvening = (24 + 19) * 60;

// Cue "4", the sixth, is the lobby. Motions 1 to 4 are two greetings, a word for those who stay and a
// good-bye; each lasts a second.
class LobbyTest : public CuesTest {
 protected:
  LobbyTest() {
    for (const char* name : {"hello", "konnichiwa", "stay", "bye"})
      show_.motions.push_back(
          {.name = name, .curves = {{show::MotionTarget::kHeadPitch, 0, {{0, 0}, {0.5F, 0.1F}, {1, 0}}}}});
    show_.lobby = show::Lobby{.cue = 5,
                              .greetings = {{"en", 1}, {"ja", 2}},
                              .stays = {{"en", 3}},
                              .goodbyes = {{"en", 4}},
                              .visitor = 1};
    board_.lines.source = board::SourceState::kLive;
    SomebodyPasses();
  }

  // There is a sensor, and it works.
  void SomebodyPasses() {
    SetSomeone(true);
    Run(400ms);
    SetSomeone(false);
    Run(5s);
  }

  void OpenLobby() {
    GoToCue(state_, show_, 5);
    Run(1s);
  }
  void SetSomeone(bool there) {
    board_.lines.value.active = there ? 1U << static_cast<unsigned>(board::Line::kPresence) : 0U;
  }
  void ComeAndBeGreeted() {
    SetSomeone(true);
    Run(400ms);
  }
  void FallAsleep() {
    SetSomeone(false);
    Run(70s);
    ASSERT_EQ(Phase(), LobbyPhase::kAsleep);
  }
  // What the wall clock says, once.
  void Tell(std::int32_t week_minute) {
    now_ += kFrame;
    InputEvents events = ReadEvents(state_.seen, board_);
    events.week_minute = week_minute;
    performed_ = Animate(state_, board_, events, show_, now_);
    state_ = performed_.state;
  }
  // Tuesdays from 18 to 20 o'clock.
  void OpenOnTuesdays() { show_.lobby->hours = {{(24 + 18) * 60, (24 + 20) * 60}}; }

  LobbyPhase Phase() const { return state_.lobby.phase; }
  int Plays() const {
    const Playing* youngest = LastCalled(state_);
    return youngest != nullptr ? youngest->motion : -1;
  }
  float Lids() const { return performed_.scene.weights.lids_shut[0]; }
  float Light() const { return performed_.scene.light.exposure; }
};

}  // namespace kaori::performance
