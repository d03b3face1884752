// The lock: while it is on only those who play are heard, so that nothing which is leant on, sat on or tried
// out changes the show.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Heard while it is on: GO, BACK, PANIC and BLACKOUT, by whichever button, key or call; all buttons of a
// dial box or a stick while a role is played from it; sticks and dials that play a role; lips, voice, and the switches.
// Not heard: every other key; buttons of a device that nobody plays; jumps, stand-by, levels from afar,
// letting go, and roles that are moved. What is let go of after it was held down when the lock came on still
// goes. Both are false while the lock is off. Pure.
bool IsLockedOut(const State& state, const Press& press, const show::Show& show);
bool IsLockedOut(const State& state, const board::Call& call);

// The same of a key's own calls: GO by a key is heard, and the scene that the same key enters besides is not.
bool IsLockedOut(const State& state, const show::Call& call);

// Counts a refusal. A button's lamp blinks twice.
void NoteLockedOut(State& state, const Press* press);

// Puts the lock on; a lock that is on stays as it is.
void Lock(State& state);

// To be called once a frame, when all that may lock has been played: turns the lock off while the service key
// is on. A lock that was asked for then is counted as denied.
void FollowServiceKey(State& state, bool was_locked, const board::Stamped<board::Lines>& lines);

}  // namespace kaori::performance
