// Which part of the picture the figure can touch: only that is cleared, and laid on the picture.
#pragma once

#include <array>
#include <vector>

#include "render/face/composer.h"
#include "render/gl/canvas.h"
#include "render/passes/frame.h"
#include "render/passes/prop_mesh.h"

namespace kaori::passes {

// Bands across the picture, from below; in each the figure lies within its box, which may be empty.
struct FigureRegion {
  static constexpr int kBands = 20;
  std::array<gl::Box, kBands> bands{};
  gl::Box whole;  // Encloses them all.
};

// For each face, the longest edge at each vertex of the cage, metres.
using LongestEdges = std::vector<std::vector<float>>;
LongestEdges MeasureEdges(const face::Cast& cast);

// Encloses the face, with what sticks out of it by `reach_m`, and all that is worn in this frame, hair as it
// swings.
FigureRegion FindFigure(const FrameBlock& frame, const face::Shape& shape, const Appearance& appearance,
                        const LongestEdges& edges, float reach_m = 0);

}  // namespace kaori::passes
