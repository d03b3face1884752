#include "render/passes/figure_box.h"

#include <algorithm>
#include <cmath>

namespace kaori::passes {
namespace {

constexpr float kMargin = 0.012F;  // Of the canvas's half size.

// Hair may swing outwards by this much.
constexpr float kSwing_m = 0.02F;

struct Bounds {
  glm::vec2 low{1e9F};
  glm::vec2 high{-1e9F};

  void Add(glm::vec2 p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

void AddProp(const FrameBlock& frame, const PropMesh& prop, Bounds& bounds) {
  const bool turns = prop.part != face::Part::kClothes;
  const glm::vec3 low = prop.lowest - (turns ? kSwing_m : 0.0F);
  const glm::vec3 high = prop.highest + (turns ? kSwing_m : 0.0F);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 p{(corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                      (corner & 4) != 0 ? high.z : low.z};
    bounds.Add(Project(frame, p, turns));
  }
}

int PixelOf(float place, int size_px) {
  const float limited = std::clamp(place, -1.0F, 1.0F);
  return static_cast<int>(std::lround((limited * 0.5F + 0.5F) * static_cast<float>(size_px)));
}

}  // namespace

gl::Box FigureBox(const FrameBlock& frame, const face::Shape& shape, const Wardrobe& wardrobe) {
  Bounds bounds;
  for (const glm::vec3& p : shape.cage) {
    bounds.Add(Project(frame, p, true));
    bounds.Add(Project(frame, p, false));  // The neck turns by less.
  }
  for (std::size_t i = 0; i < wardrobe.meshes().size(); ++i) {
    if (wardrobe.presence(i) > 0) AddProp(frame, wardrobe.meshes()[i], bounds);
  }
  const int width_px = static_cast<int>(frame.sway.z);
  const int height_px = static_cast<int>(frame.sway.w);
  gl::Box box;
  box.left_px = PixelOf(bounds.low.x - kMargin, width_px);
  box.bottom_px = PixelOf(bounds.low.y - kMargin, height_px);
  box.width_px = PixelOf(bounds.high.x + kMargin, width_px) - box.left_px;
  box.height_px = PixelOf(bounds.high.y + kMargin, height_px) - box.bottom_px;
  return box;
}

}  // namespace kaori::passes
