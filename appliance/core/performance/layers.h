// Layers of takes: which of them give way to whom, level by level.
//
// Of those who want a level the strongest has it: what it rests at, life, takes of the layer under, a remote control,
// lips and voice, takes of the layer over, and hands. Takes of the layer add are added to whoever has it.
#pragma once

#include <array>

#include "appliance/core/show/level.h"
#include "appliance/core/show/motion.h"
#include "appliance/core/show/roles.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

struct State;
struct Playing;

// How the two layers have one level. Plain bytes, a part of State; shares are 0..1.
struct LayerNow {
  float under = 1,
        over = 1;    // 0: somebody who is stronger has the level; 1: nobody has. Eased by SmoothStep.
  float moved = 0;   // How far such takes moved it in the last frame, in the level's own unit.
  float has = 0;     // How much of the level such takes had in the last frame,
  float covers = 0;  // and those of the layer over alone, which remote controls and lips give way to.
};
using LayersNow = std::array<LayerNow, show::kLevelCount>;

// Lets takes give way to who has their levels now, and come back. As with all owners nothing jumps: it takes the
// roles' hand-over time, or longer where the way is long. After MoveLevels; `dt_s` counts in pauses of the cue list
// too.
void MoveLayers(State& state, const show::Roles& roles, float dt_s);

// Before the motions of a frame are played: nothing is had yet.
void ClearLayers(State& state);

// How much of a curve counts, 0..1. `value` is what it adds at most, in its level's unit. Notes what it has.
float LayerShare(State& state, const show::Show& show, const show::MotionCurve& curve, const Playing& voice,
                 float value);

}  // namespace kaori::performance
