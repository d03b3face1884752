// A texture while it is painted: linear colour and gloss per texel, fine strokes, and the finish.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "appliance/authoring/appearance/atlas.h"
#include "render/face/cast.h"

namespace kaori::appearance {

// What a texel holds while it is painted.
struct Paint {
  // Linear RGB.
  glm::vec3 colour{};
  float gloss = 0;  // 0 matt .. 1 wet.

  // Lays `over` on top, as opaque as `amount` (clamped to 0..1).
  void Mix(float amount, glm::vec3 over);
  // As Mix, for the gloss alone.
  void MixGloss(float amount, float over);
};

// A hair: a bent line (quadratic Bézier) that is widest at its root and ends in a point.
struct Stroke {
  // Places of the unrolled surface: where it starts, the middle control point of its curve, and
  // where it ends.
  glm::vec2 root_cm{};
  glm::vec2 bend_cm{};
  glm::vec2 tip_cm{};
  // At its root; it ends in a point.
  float half_width_cm = 0.02F;
  // At its root, 0..1.
  float opacity = 1;
  glm::vec3 colour{};
};

// A texture in work; not thread-safe. A uv that the texture does not hold is clipped.
class Canvas {
 public:
  // Borrows the atlas for its own life.
  explicit Canvas(const Atlas& atlas) : atlas_(atlas), texels_(atlas.texels.size()) {}

  const Atlas& atlas() const { return atlas_; }
  // By the atlas's order.
  Paint& at(std::size_t i) { return texels_[i]; }

  // The colour at a uv, for strokes that take after what they lie on.
  glm::vec3 Sample(glm::vec2 uv_cm) const;

  // Rasterises the stroke with soft edges of one texel, laid over what is there. Time grows with the stroke's
  // box in texels. Nothing is drawn in the mouth's bag.
  void Draw(const Stroke& stroke);

  // The texture, as sRGB bytes with gloss in alpha. What no triangle covers takes the colour of its nearest
  // neighbours, so that neither filtering nor mipmaps pull in a foreign colour at an edge.
  face::Texture Finish() &&;

 private:
  // Paints all that is not covered, from its edges outwards.
  void FillOutside();
  // The mean of the neighbours that are filled; one at least is.
  void FillFrom(std::size_t texel, const std::vector<std::uint8_t>& filled);

  const Atlas& atlas_;
  std::vector<Paint> texels_;
};

}  // namespace kaori::appearance
