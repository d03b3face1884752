// The few numbers of a face that are blended with it: eyes, their look, the mouth's fit, the jaw and the
// lids. Each is the weighted mean over the faces, as positions are. Pure; nothing allocates.
#pragma once

#include <array>
#include <span>

#include "render/face/cast.h"
#include "render/face/composites.h"
#include "render/face/weights.h"

namespace kaori::face {

// `weights` as from Playable, in all of these: indices exist, faces sum to 1. [0] is the character's left.
std::array<EyeBall, 2> MixEyes(std::span<const Face> faces, const Weights& weights);
// Iris and lashes, by the weights of the faces.
EyeLook MixEyeLook(std::span<const Face> faces, const Weights& weights);
// Paint and gloss of the eyeballs, by the weights of the faces; pupils also by those of expressions and channels.
EyeSurface MixEyeSurface(std::span<const Face> faces, std::span<const Expression> expressions,
                         const Weights& weights);
// How red the face is, 0..1: what its surfaces show of what the expressions ask for.
float MixFlush(std::span<const Face> faces, std::span<const Expression> expressions, const Weights& weights);
// Scale, offset and presence of teeth and tongue, by the weights of the faces.
MouthFit MixMouth(std::span<const Face> faces, const Weights& weights);

// By the operator and by the expressions together: left, right, 0 open .. 1 shut. Either shuts what the other
// left open.
std::array<float, 2> MixLids(std::span<const Expression> expressions, const Weights& weights);

// How far the lower lip's middle goes down, metres, never negative. The part of it that belongs to the mouth
// yields with mouth_given_away, as the vertices there do.
float MixJawDrop(const Composites& composites, const Weights& weights);

}  // namespace kaori::face
