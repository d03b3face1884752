// The head's surface unrolled: what lies under each texel of a texture. All faces of a cast share one atlas.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "appliance/authoring/sculpt/paint_attributes.h"
#include "render/face/topology.h"

namespace kaori::appearance {

// Interpolated over the triangle that covers it; lengths in centimetres of the unrolled surface, u positive
// on the character's left.
struct Texel {
  glm::vec2 place_cm{};   // Known everywhere, also outside the surface.
  float eye_ring = 0;     // 0 .. 7, never negative: it does not jump through 0 at an eye's corners.
  float eye_upper = 0;    // 0 below the eye .. 1 above it.
  float mouth_ring = 0;   // 0 .. 6.
  float mouth_upper = 0;  // 0 lower lip .. 1 upper lip.
  float bag = 0;
  float ear_ring = 0;
  float spout = 0;
  bool covered = false;  // A triangle of the fine mesh lies here.

  glm::vec2 mirrored() const { return {place_cm.x < 0 ? -place_cm.x : place_cm.x, place_cm.y}; }
};

struct Atlas {
  int size_px = 0;
  std::vector<Texel> texels;  // Row-major, top row first.

  const Texel& at(int x, int y) const {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_px) +
                  static_cast<std::size_t>(x)];
  }
};

// Rasterises the fine mesh in texture space. `attributes` holds one entry for each vertex of the cage.
// The texture is `size_px` on a side. Pure.
Atlas UnrollSurface(const face::Topology& topology, const std::vector<sculpt::PaintAttributes>& attributes,
                    int size_px);

// The texel whose centre is nearest to a place, in texels from the top left; may lie between two.
glm::vec2 TexelFromPlace(glm::vec2 place_cm, int size_px);

}  // namespace kaori::appearance
