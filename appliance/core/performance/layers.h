// Layers of takes: which of them give way to whom, level by level.
//
// Of those who want a level the strongest has it: what it rests at, life, takes of the layer under, a remote control,
// lips and voice, takes of the layer over, and operator input. Takes of the layer add are added to whoever has it. Of two takes
// of one layer the one that was called later has it. All this is for each level, and for each expression, by itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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

// One frame of the takes that play, from the strongest to the weakest. Borrows state and show, and the take of Begin
// until the next one. Allocates nothing.
class TakesFrame {
 public:
  // Nothing is had yet.
  TakesFrame(State& state, const show::Show& show);

  // What those before this one have, it has not.
  void Begin(const Playing& take);

  // How much of a curve of that take counts, 0..1. `value` is what it adds at most, in its level's unit. Notes in the
  // state what the take has.
  float ShareOf(const show::MotionCurve& curve, float value);

 private:
  // An expression that is no level, as far as takes have it: all of this frame, and those before this one.
  struct Taken {
    std::uint16_t expression = 0;
    float has = 0, before = 0;
  };
  Taken* TakenOf(std::uint16_t expression);
  float ShareOfExpression(const show::MotionCurve& curve, float own);

  State& state_;
  const show::Show& show_;
  const Playing* take_ = nullptr;
  std::array<float, show::kLevelCount> before_{};        // What stronger takes have of each level.
  std::array<float, show::kLevelCount> moved_before_{};  // LayerNow::moved of the frame before.
  // More expressions than takes move at once; what finds no room is added.
  std::array<Taken, 64> taken_{};
  std::size_t taken_count_ = 0;
};

}  // namespace kaori::performance
