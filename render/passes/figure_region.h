// Which part of the picture the figure can touch: only that is cleared, and laid on the picture.
#pragma once

#include <array>
#include <vector>

#include "render/face/composer.h"
#include "render/gl/canvas.h"
#include "render/passes/frame.h"
#include "render/passes/prop_mesh.h"

namespace kaori::passes {

// Bands across the picture, from below, each a twentieth of its height; in each the figure lies within its
// box, which may be empty. Tighter than one box round all, and on a software renderer every pixel that is
// left out counts.
struct FigureRegion {
  static constexpr int kBands = 20;
  std::array<gl::Box, kBands> bands{};
  // Encloses them all.
  gl::Box whole;
};

// For each face, the longest edge at each vertex of the cage, metres.
using LongestEdges = std::vector<std::vector<float>>;
LongestEdges MeasureEdges(const face::Cast& cast);

// Encloses the face, with what sticks out of it by `reach_m`, and all that is worn in this frame, hair as it
// swings. Works on the cage: the fine mesh stays within part of an edge of it, which is what `edges` are for.
// Allocates nothing.
FigureRegion FindFigure(const FrameBlock& frame, const face::Shape& shape, const Appearance& appearance,
                        const LongestEdges& edges, float reach_m = 0);

}  // namespace kaori::passes
