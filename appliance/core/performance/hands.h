// The operators' hands: dials to knobs, buttons and keys to calls, sticks to head, gaze and brows.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Turns of the dials since the last frame move the knobs, each within its range.
void TurnKnobs(State& state, const board::Surface& surface);

// What the knobs do follows them softly: a detent is not seen.
void FollowKnobs(State& state, float dt_s);

// Buttons that went down since the last frame call faces, expressions, styles and scenes.
void PushButtons(State& state, const board::Surface& surface, const show::Show& show);

// Keys that went down since the last frame: blink and winks, registered motions, scenes.
void StrikeKeys(State& state, const board::Keys& keys, const show::Show& show);

// Sets face, expression, style, light and backdrop of a scene on their way.
void EnterScene(State& state, const show::Show& show, std::uint16_t scene, float fade_s);

// Head, gaze and brows follow the sticks; a stick that is gone eases to neutral.
void MoveSticks(State& state, const board::Snapshot& board, float dt_s);

// Lids that keys hold shut, and blinks that run: the shut part of the character's left, right eye, 0..1.
std::array<float, 2> Lids(State& state, const board::Keys& keys, float dt_s);

}  // namespace kaori::performance
