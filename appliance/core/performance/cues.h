// The cue list as it is played: GO, BACK, STOP, PAUSE, PANIC and BLACKOUT, and the waits between cues.
//
// All of it is part of the performance's state, so that a stage that was killed goes on in the middle of a
// wait, and plays a GO that was called while it was away.
#pragma once

#include <cstddef>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Does at once what a person called `ago_s` before the moment of this frame, from 0 on. A GO within the
// list's guard after the last one, by the times at which people called, or after the last cue, is refused and
// counted. A GO while a chain of cues still waits first plays what is left of that chain, so
// that nothing which the list sets is ever missed. `show.cue_list` is tracked (show::Track). Does nothing
// where the list was not tracked. Allocates nothing.
void CallCue(State& state, const show::Show& show, show::CueVerb verb, float ago_s = 0);

// Fades within the list's goto_s into what stands after cue number `index`, whatever was played before, and
// stands by for the cue after it. A cue that others follow by themselves is jumped to with all of those. -1:
// as the show opens. What waits is stopped first. `index` is -1 or below the number of cues.
void GoToCue(State& state, const show::Show& show, std::int32_t index);

// GO plays the cue `index` next, or the one that brings it by itself. Nothing else changes. `index` is below
// the number of cues.
void StandByCue(State& state, const show::Show& show, std::int32_t index);

// Moves the waits of the list on by dt_s and plays the cues that have become due, each by itself. `dt_s` is
// the time of the frame, pause or not. To be called once a frame, after what people called.
void PlayCues(State& state, const board::Snapshot& board, const show::Show& show, float dt_s);

// Of dt_s, what passes for fades, motions and waits: nothing while the list is paused.
float PlayTime(const State& state, float dt_s);

// To be called when the fades have moved on. Where they have run, what lies behind them (what a dial that is
// turned back shows) is as the list has it: a jump and a run through the list end in the same bits.
void SettleCues(State& state, const show::Show& show);

}  // namespace kaori::performance
