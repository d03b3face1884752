// A performance that goes on after the box was off.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"

namespace kaori::performance {

// `kept` on a board and a clock that began anew: face, expression, scene, look and dials as they were, every
// fade done, and no motion, blink or blackout of that show. `kept` is valid (IsValid). Pure. The blackout is
// as the switch stands now.
State Recalled(const State& kept, const board::Snapshot& board, Time presented_at);

// For a state that was found: roles that the show has gained since, by a file of the box's own, are played from
// their own devices, and the others from where they were.
void AdoptRoles(State& state, const show::Roles& roles);

}  // namespace kaori::performance
