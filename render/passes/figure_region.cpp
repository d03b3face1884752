#include "render/passes/figure_region.h"

#include <algorithm>
#include <cmath>

namespace kaori::passes {
namespace {

// Neighbouring points of the cage lie no farther apart, and lashes, swinging hair and lines stay within it.
constexpr float kMargin_m = 0.02F;

struct Span {
  int from_px = 0;
  int to_px = 0;
};

// Collects rectangles into bands of equal height.
class Bands {
 public:
  explicit Bands(glm::vec2 canvas_px) : canvas_px_(canvas_px) {
    spans_.fill({static_cast<int>(canvas_px.x), 0});
  }

  // Corners in the picture, each from -1 to 1.
  void Add(glm::vec2 low, glm::vec2 high) {
    if (!(low.x < 1 && low.y < 1 && high.x > -1 && high.y > -1)) return;
    const int left = Pixel(low.x, canvas_px_.x);
    const int right = Pixel(high.x, canvas_px_.x) + 1;
    for (int b = BandOf(low.y); b <= BandOf(high.y); ++b) {
      Span& span = spans_[static_cast<std::size_t>(b)];
      span = {std::min(span.from_px, left), std::max(span.to_px, right)};
    }
  }

  FigureRegion Region() const {
    FigureRegion region;
    Span all{static_cast<int>(canvas_px_.x), 0};
    for (int b = 0; b < FigureRegion::kBands; ++b) {
      const Span span = spans_[static_cast<std::size_t>(b)];
      const int bottom = Edge(b);
      const int right = std::min(span.to_px, static_cast<int>(canvas_px_.x));
      region.bands[static_cast<std::size_t>(b)] = {span.from_px, bottom, std::max(right - span.from_px, 0),
                                                   Edge(b + 1) - bottom};
      all = {std::min(all.from_px, span.from_px), std::max(all.to_px, right)};
    }
    region.whole = {all.from_px, 0, std::max(all.to_px - all.from_px, 0), static_cast<int>(canvas_px_.y)};
    return region;
  }

 private:
  static int Pixel(float place, float size_px) {
    return static_cast<int>((std::clamp(place, -1.0F, 1.0F) * 0.5F + 0.5F) * size_px);
  }
  static int BandOf(float place) {
    return std::min(Pixel(place, static_cast<float>(FigureRegion::kBands)), FigureRegion::kBands - 1);
  }
  int Edge(int band) const { return static_cast<int>(canvas_px_.y) * band / FigureRegion::kBands; }

  glm::vec2 canvas_px_;
  std::array<Span, FigureRegion::kBands> spans_{};
};

// A box about the head or the shoulders, seen in the picture.
void AddBox(const FrameBlock& frame, const Box3& box, bool turns, Bands& bands) {
  glm::vec2 low{1e9F};
  glm::vec2 high{-1e9F};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 p{(corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                      (corner & 4) != 0 ? box.high.z : box.low.z};
    const glm::vec2 seen = Project(frame, p, turns);
    low = glm::min(low, seen);
    high = glm::max(high, seen);
  }
  bands.Add(low, high);
}

void AddProp(const FrameBlock& frame, const PropMesh& prop, Bands& bands) {
  const bool turns = prop.part != face::Part::kClothes;
  for (Box3 slice : prop.slices) {
    if (slice.low.x > slice.high.x) continue;
    if (turns) slice = {slice.low - kMargin_m, slice.high + kMargin_m};
    AddBox(frame, slice, turns, bands);
  }
}

}  // namespace

FigureRegion FindFigure(const FrameBlock& frame, const face::Shape& shape, const Wardrobe& wardrobe) {
  Bands bands({frame.sway.z, frame.sway.w});
  const float distance_m = -(frame.view * glm::vec4(0, 0, 0, 1)).z;
  const glm::vec2 margin =
      kMargin_m / std::max(distance_m, 0.1F) * glm::vec2(frame.projection[0][0], frame.projection[1][1]);
  for (const glm::vec3& p : shape.cage) {
    const glm::vec2 turned = Project(frame, p, true);
    const bool neck = p.y < frame.shift.w;  // It turns by less.
    const glm::vec2 still = neck ? Project(frame, p, false) : turned;
    bands.Add(glm::min(turned, still) - margin, glm::max(turned, still) + margin);
  }
  for (std::size_t i = 0; i < wardrobe.meshes().size(); ++i) {
    if (wardrobe.presence(i) > 0) AddProp(frame, wardrobe.meshes()[i], bands);
  }
  return bands.Region();
}

}  // namespace kaori::passes
