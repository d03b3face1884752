// Which part of the picture the figure can touch: only that is cleared, and laid on the picture.
#pragma once

#include <array>

#include "render/face/composer.h"
#include "render/gl/canvas.h"
#include "render/passes/frame.h"
#include "render/passes/prop_mesh.h"

namespace kaori::passes {

// Bands across the picture, from below; in each the figure lies within its box, which may be empty.
struct FigureRegion {
  static constexpr int kBands = 16;
  std::array<gl::Box, kBands> bands{};
  gl::Box whole;  // Encloses them all.
};

// Encloses the face and all that is worn in this frame, with a margin for swinging hair, lashes and thick
// lines.
FigureRegion FindFigure(const FrameBlock& frame, const face::Shape& shape, const Wardrobe& wardrobe);

}  // namespace kaori::passes
