// Which part of the picture the figure can touch: only that is drawn with samples.
#pragma once

#include "render/face/composer.h"
#include "render/gl/canvas.h"
#include "render/passes/frame.h"
#include "render/passes/prop_mesh.h"

namespace kaori::passes {

// Encloses the face and all that is worn in this frame, with a margin for swinging hair, lashes and thick
// lines.
gl::Box FigureBox(const FrameBlock& frame, const face::Shape& shape, const Wardrobe& wardrobe);

}  // namespace kaori::passes
