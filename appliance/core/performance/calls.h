// What people call, by whichever control: faces, expressions, styles, scenes, motions and the cue list.
#pragma once

#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Does what was called since the last frame, in the order of time, by buttons, keys, and calls on the board:
// buttons call faces, expressions, styles, scenes and registered motions; keys too, and they blink and wink.
// A motion that loops ends when it is called once more. What a button or key calls exists in the show:
// CheckShow has refused others. A call on the board that names what the show has not is refused and counted.
// `passed_s` is the time since the frame before, of which the calls are.
void PlayCalls(State& state, const InputEvents& events, const show::Show& show, float passed_s);

// A fresh call takes over whole, whatever its dial said about the one before: the dial is full. `face` and
// `expression` are below the counts of the show's. A fade of 0 changes at once. Toggles of the same kind end
// with it.
void CallFace(State& state, std::uint16_t face, float fade_s, show::FadeCurve curve = show::FadeCurve::kS);
void CallExpression(State& state, std::uint16_t expression, float fade_s,
                    show::FadeCurve curve = show::FadeCurve::kS);

// Sets face, expression, style, exposure and backdrop of a scene on their way, each from what it is at this
// moment. `scene` is below show.scenes.size(). A fade of 0 changes at once.
void EnterScene(State& state, const show::Show& show, std::uint16_t scene, float fade_s);

}  // namespace kaori::performance
