// What the operators' input does: dials move knobs, buttons and keys call, sticks move head, gaze and brows.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Turns of the dials move the knobs, each within its range. A value below 1 counts as 1 count per turn.
void TurnKnobs(State& state, const InputEvents& events, std::int32_t counts_per_turn);

// What the knobs do follows them softly, with a half life of 30 ms: a detent is not seen.
void FollowKnobs(State& state, float dt_s);

// Presses, in their order: buttons call faces, expressions, styles and scenes; keys too, and they blink, wink and
// play registered motions. Calls that the show does not have never come here: CheckShow has refused such a show.
void PlayPresses(State& state, const InputEvents& events, const show::Show& show);

// A fresh call takes over whole, whatever its dial said about the one before: the dial is full. `face` and `expression`
// are below the counts of the show's. A fade of 0 changes at once.
void CallFace(State& state, std::uint16_t face, float fade_s);
void CallExpression(State& state, std::uint16_t expression, float fade_s);

// Begins a registered motion of the show. No playing voice is cut off for it: that would be a jump. Eight within a quarter
// of a second are no playing, the ninth is not heard.
void PlayMotion(State& state, std::int32_t motion);

// Sets face, expression, style, exposure and backdrop of a scene on their way, each from what it is at this
// moment. `scene` is below show.scenes.size(). A fade of 0 changes at once.
void EnterScene(State& state, const show::Show& show, std::uint16_t scene, float fade_s);

// Head, gaze and brows follow the sticks. A stick that is unplugged or silent holds for a quarter of a
// second, then eases to neutral within one.
void MoveSticks(State& state, const board::Snapshot& board, float dt_s);

// Lids that keys hold shut, and blinks that run: the shut part of the character's left, right eye, 0..1. The
// greater of the two counts. Moves the blinks on by dt_s.
std::array<float, 2> Lids(State& state, const board::Keys& keys, float dt_s);

}  // namespace kaori::performance
