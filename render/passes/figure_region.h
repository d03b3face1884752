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
// left out counts. Too large a region costs time; too small a one cuts the figure off.
struct FigureRegion {
  static constexpr int kBands = 20;
  // From below; each as wide as the figure is there.
  std::array<gl::Box, kBands> bands{};
  // Encloses them all; as high as the picture.
  gl::Box whole;
};

// For each face, the longest edge at each vertex of the cage, metres: it bounds how far from that vertex the
// fine mesh can be.
using LongestEdges = std::vector<std::vector<float>>;
// Once for a cast, on any thread.
LongestEdges MeasureEdges(const face::Cast& cast);

// How far things reach beyond where they are at rest, metres: the editor's handles out of the skin, clothes
// and hair that are fitted to another neck and head.
struct Reaches {
  float handles_m = 0;
  float clothes_m = 0;
  float hair_m = 0;
};

// Encloses the face, with what sticks out of it, and all that is worn in this frame, hair as it swings. Works
// on the cage: the fine mesh stays within part of an edge of it, which is what `edges` are for. `appearance`
// must have been weighed for this frame. Allocates nothing; projects each vertex of the cage once or twice.
FigureRegion FindFigure(const FrameBlock& frame, glm::vec2 picture_px, const face::Shape& shape,
                        const Appearance& appearance, const LongestEdges& edges, const Reaches& reaches = {});

}  // namespace kaori::passes
