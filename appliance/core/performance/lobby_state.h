// Where the lobby stands, as a part of the performance's state.
#pragma once

#include <array>
#include <cstdint>

#include "appliance/core/show/show.h"

namespace kaori::performance {

// What she does by herself in the foyer.
enum class LobbyPhase : std::uint32_t {
  kOff,        // The show has no lobby, or its cue does not stand.
  kAsleep,     // Lids shut, dim light.
  kWaiting,    // Awake, and nobody is there.
  kGreeting,   // A greeting plays,
  kWith,       // is over, and the visitor is still there.
  kGoodbye,    // She says good-bye, whoever comes meanwhile.
  kTakenOver,  // An operator has her.
};
inline constexpr std::uint32_t kLobbyPhaseCount = 7;

// The wall clock was never told, or is known to be wrong.
inline constexpr std::int32_t kNoWeekMinute = -1;

struct LobbyNow {
  LobbyPhase phase = LobbyPhase::kOff;
  float left_s = 0;            // Of the phase, where it ends by time.
  float changing_s = 0;        // For how long the sensor has said the contrary of `someone`.
  float asleep = 0;            // 0 awake .. 1 asleep, on its way.
  std::uint32_t someone = 0;   // 1: somebody is there, as the sensor says without its flicker.
  std::uint32_t sensed = 0;    // 1: the sensor has seen somebody since the show began: there is one.
  float on_s = 0;              // For how long it has said so without a break, up to the lobby's stuck_s.
  std::int32_t greeting = -1;  // Of each list the take that was played last; -1: none was.
  std::int32_t stay = -1, goodbye = -1;
  std::int32_t week_minute = kNoWeekMinute;  // Of local time, as it was told last.
  std::array<float, 2> sliders{};            // Of the sticks, as they stood when they were moved last.
};

// Whether the sensor has said for so long that somebody is there that it is taken for stuck.
bool IsSensorStuck(const LobbyNow& now, const show::Show& show);

// Whether such a state can be gone on with.
bool IsValidLobby(const LobbyNow& now, const show::Show& show);

}  // namespace kaori::performance
