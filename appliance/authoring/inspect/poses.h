// The poses that a face is looked at in: what a show plays of it, bounded.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/face/cast.h"
#include "render/face/weights.h"

namespace kaori::inspect {

// Weights of everything but the face, with a name for people.
struct Pose {
  std::string name{};  // "laugh", "laugh with mouth_open_wide, lids shut".
  face::Weights weights{};
  bool shut = false;  // The lids are.
  // One expression, mouth shape or channel and nothing on top of it.
  bool alone = false;
};

// In this order, which begins with the face at rest:
//
//   Of each kind alone, then each expression
//     with each mouth shape, to which its own mouth gives way,
//     with each channel, the two sides of one together;
//   those alone and those with a channel come again with lids shut.
//
// All pairs, and no more: their number grows with the product of expressions and channels. expressions[0]
// must be "neutral". Weights name no face: that is the caller's.
std::vector<Pose> PosesToSee(const std::vector<face::Expression>& expressions);

}  // namespace kaori::inspect
