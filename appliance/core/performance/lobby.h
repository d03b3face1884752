// The lobby: she wakes for those who come, looks at them, greets, says good-bye and sleeps. An operator who
// touches a control has her, until nobody has touched one for a while. There is no menu.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Moves the lobby on by dt_s, when all that people called in this frame has been played. Presence comes from
// the board, and the time of day from `events`, so that an evening plays again as it was. A show without a
// lobby, or whose list is not tracked, changes nothing. While the time of day is not known the lobby is open.
// Pure; allocates nothing.
void PlayLobby(State& state, const board::Snapshot& board, const InputEvents& events, const show::Show& show,
               float dt_s);

// Whether opening hours are of use here: the show has some, and the time of day is known.
bool KnowsHours(const LobbyNow& now, const show::Lobby& lobby);
// Whether the lobby is open now; true where KnowsHours is false.
bool IsOpen(const LobbyNow& now, const show::Lobby& lobby);

// What sleep makes of a frame, each for a lobby that sleeps as much as `asleep` says.
float LidsAsleep(const LobbyNow& now);                           // 0 open .. 1 shut.
float LightAsleep(const LobbyNow& now, const show::Show& show);  // A factor of the exposure, 0 .. 1.
float BreathAsleep(const State& state, float breath);            // Slow, -1 out .. 1 in.
float ExpressionAsleep(const LobbyNow& now);                     // A factor of every expression, 0 .. 1.
float HeadAsleep_rad(const LobbyNow& now);                       // Of pitch: a head sinks in sleep.

}  // namespace kaori::performance
