// The head's surface unrolled: what lies under each texel of a texture. All faces of a cast share one atlas.
//
// Lengths of this folder are centimetres of the reference face, in the frame of the cast, until a mesh is
// finished as a prop or a texture as bytes. Everything is pure and single-threaded unless it says otherwise,
// and chance is seeded: the same files give the same bytes.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "appliance/authoring/sculpt/paint_attributes.h"
#include "render/face/topology.h"

namespace kaori::appearance {

// What lies under one texel: attributes interpolated over the triangle that covers it, as painters need them.
// u is positive on the character's left.
struct Texel {
  // On the unrolled surface (sculpt/texture_map.h). Known everywhere, also outside the surface.
  glm::vec2 uv_cm{};
  // 0 .. 7, never negative: it does not jump through 0 at an eye's corners.
  float eye_ring = 0;
  // 0 below the eye .. 1 above it; fades over the corners.
  float eye_upper = 0;
  // 0 .. 6; 6 in the bag, too.
  float mouth_ring = 0;
  float mouth_upper = 0;  // 0 lower lip .. 1 upper lip.
  // As sculpt::PaintAttributes, interpolated.
  float bag = 0;
  float ear_ring = 0;
  float spout = 0;
  bool covered = false;  // A triangle of the fine mesh lies here.

  // The uv on the left half: most paint is the same on both sides.
  glm::vec2 mirrored() const { return {uv_cm.x < 0 ? -uv_cm.x : uv_cm.x, uv_cm.y}; }
};

// A square of texels, made once for a cast and borrowed by every canvas.
struct Atlas {
  // Of a side.
  int size_px = 0;
  std::vector<Texel> texels;  // Row-major, top row first.

  const Texel& at(int x, int y) const {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_px) +
                  static_cast<std::size_t>(x)];
  }
};

// Rasterises the fine mesh in texture space. `attributes` holds one entry for each vertex of the cage.
// The texture is `size_px` on a side. The topology must be that of the sculptor's cage. Pure; time grows
// with the texels.
Atlas UnrollSurface(const face::Topology& topology, const std::vector<sculpt::PaintAttributes>& attributes,
                    int size_px);

// The texel whose centre is nearest to a uv, in texels from the top left; may lie between two.
glm::vec2 TexelFromUv(glm::vec2 uv_cm, int size_px);

}  // namespace kaori::appearance
