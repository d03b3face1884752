// Who has each level, and how it passes from one owner to the next.
//
// Operator input wins at once and nothing jumps: a new owner starts from the value of the moment plus its own
// movement, and the difference eases out (Roles::handover_s). Of two operators on one level the later one has it.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Every role on its own device, every level that goes back to a rest there, and no control has been seen. The
// others are as State::knobs has them.
void BeginLevels(State& state, const show::Roles& roles);

// The same, and every role stays on its device: nobody has moved anything on this board yet.
void RestLevels(State& state);

// Moves all levels by one frame: dials by what they have turned, sticks by where they stand. A stick that is
// unplugged or silent holds for a quarter of a second, then eases to its middle within one. What others have
// put into State::knobs since the last call is taken for a cue's. `roles` are the show's (CheckRoles).
// Allocates nothing.
void MoveLevels(State& state, const board::Snapshot& board, const InputEvents& events,
                const show::Roles& roles, float dt_s);

// A remote control's word, which counts for a second. A hand that has the level keeps it. Values beyond an
// end are the end.
void SetRemotely(State& state, const show::Roles& roles, show::Level level, float value);

// Whoever has the level lets go of it: it eases to its rest, or stays where it is (show::Stays). A role has
// it again when its control is moved.
void LetGo(State& state, const show::Roles& roles, show::Level level);

// The role is played from this device from now on; kNoDevice: by nobody. Levels that it has are let go of.
// False where there is no such role or device.
bool LoadRole(State& state, const show::Roles& roles, std::uint32_t role, std::uint32_t device);

}  // namespace kaori::performance
