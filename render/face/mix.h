// The few numbers of a face that are blended with it: eyes, their look, the mouth's fit, the jaw and the
// lids.
#pragma once

#include <array>
#include <span>

#include "render/face/cast.h"
#include "render/face/composites.h"
#include "render/face/weights.h"

namespace kaori::face {

// `weights` as from Playable, in all of these.
std::array<EyeBall, 2> MixEyes(std::span<const Face> faces, const Weights& weights);
EyeLook MixEyeLook(std::span<const Face> faces, const Weights& weights);
MouthFit MixMouth(std::span<const Face> faces, const Weights& weights);

// By the operator and by the expressions together: left, right, 0..1.
std::array<float, 2> MixLids(std::span<const Expression> expressions, const Weights& weights);

// Metres, never negative.
float MixJawDrop(const Composites& composites, const Weights& weights);

}  // namespace kaori::face
