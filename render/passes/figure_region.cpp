#include "render/passes/figure_region.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace kaori::passes {
namespace {

// Lashes and lines stay within this distance of the face. From one end or the other, half of an edge is
// reached; expressions stretch edges by a quarter at most.
constexpr float kLashes_m = 0.006F;
constexpr float kEdgeShare = 0.5F * 1.25F;

// Tips swing by this much for each radian, as hair.vert.
constexpr float kSwing_m = 0.11F;
constexpr float kSoftEdge_m = 0.002F;

// Columns [from_px, to_px); nothing where from_px lies beyond.
struct Span {
  int from_px = 0;
  int to_px = 0;
};

// Of the face at rest; expressions are allowed for by kEdgeShare.
std::vector<float> LongestEdgesOf(const face::Topology& topology, const face::Face& face) {
  std::vector<float> longest_m(topology.vertex_count);
  for (const face::Triangle& t : topology.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const face::Index a = t[i];
      const face::Index b = t[(i + 1) % 3];
      const float length_m = glm::distance(face.positions[a], face.positions[b]);
      longest_m[a] = std::max(longest_m[a], length_m);
      longest_m[b] = std::max(longest_m[b], length_m);
    }
  }
  return longest_m;
}

// What a metre at the face measures in the picture, x and y.
glm::vec2 SeenPerMetre(const FrameBlock& frame) {
  const float distance_m = -(frame.view * glm::vec4(0, 0, 0, 1)).z;
  return glm::vec2(frame.projection[0][0], frame.projection[1][1]) / std::max(distance_m - 0.1F, 0.1F);
}

// Collects rectangles into bands of equal height.
class Bands {
 public:
  // No span yet: from beyond to.
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

  // Bands are cut so that together they are as high as the picture, whatever its height.
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
  static int Pixel(float at, float size_px) {
    return static_cast<int>((std::clamp(at, -1.0F, 1.0F) * 0.5F + 0.5F) * size_px);
  }
  static int BandOf(float at) {
    return std::min(Pixel(at, static_cast<float>(FigureRegion::kBands)), FigureRegion::kBands - 1);
  }
  int Edge(int band) const { return static_cast<int>(canvas_px_.y) * band / FigureRegion::kBands; }

  glm::vec2 canvas_px_;
  std::array<Span, FigureRegion::kBands> spans_{};
};

// The slice's prism, with a margin, as the rectangle that encloses its corners in the picture.
void AddSlice(const FrameBlock& frame, const Slice& slice, Follows follows, float margin_m, Bands& bands) {
  const float low_m = slice.low_m - margin_m;
  const float high_m = slice.high_m + margin_m;
  glm::vec2 low{1e9F};
  glm::vec2 high{-1e9F};
  for (const glm::vec2& corner : slice.outline) {
    for (const float y_m : {low_m, high_m}) {
      const glm::vec2 seen = Project(frame, {corner.x, y_m, corner.y}, follows);
      low = glm::min(low, seen);
      high = glm::max(high, seen);
    }
  }
  const glm::vec2 margin = margin_m * SeenPerMetre(frame);
  bands.Add(low - margin, high + margin);
}

// Hair reaches as far beyond its slices as its tips swing; everything as far as breath lifts it.
void AddProp(const FrameBlock& frame, const PropMesh& prop, const Reaches& reaches, Bands& bands) {
  const bool clothes = prop.part == face::Part::kClothes;
  const glm::vec4 sides = glm::abs(frame.sway_sides);
  const float swing_rad =
      std::max({std::abs(frame.sway.x), std::abs(frame.sway.y), sides.x, sides.y, sides.z, sides.w});
  const float margin_m = kSoftEdge_m + (clothes ? reaches.clothes_m : reaches.hair_m + kSwing_m * swing_rad) +
                         std::abs(frame.up.w);
  for (const Slice& slice : prop.slices) {
    if (!slice.empty()) AddSlice(frame, slice, clothes ? Follows::kBody : Follows::kHead, margin_m, bands);
  }
}

}  // namespace

LongestEdges MeasureEdges(const face::Cast& cast) {
  LongestEdges edges;
  for (const face::Face& f : cast.faces) edges.push_back(LongestEdgesOf(cast.topology, f));
  return edges;
}

FigureRegion FindFigure(const FrameBlock& frame, glm::vec2 picture_px, const face::Shape& shape,
                        const Appearance& appearance, const LongestEdges& edges, const Reaches& reaches) {
  Bands bands(picture_px);
  const glm::vec2 per_metre = SeenPerMetre(frame);
  for (std::size_t i = 0; i < shape.cage.size(); ++i) {
    float margin_m = std::max(kLashes_m, reaches.handles_m) + std::abs(frame.up.w);
    for (const face::Term& f : shape.faces) margin_m += f.weight * kEdgeShare * edges[f.index][i];
    const glm::vec3 p = shape.cage[i];
    const glm::vec2 turned = Project(frame, p, Follows::kSkin);
    const bool neck = p.y < frame.shift.w;  // It turns by less.
    const glm::vec2 still = neck ? Project(frame, p, Follows::kBody) : turned;
    const glm::vec2 margin = per_metre * margin_m;
    bands.Add(glm::min(turned, still) - margin, glm::max(turned, still) + margin);
  }
  for (std::size_t i = 0; i < appearance.meshes().size(); ++i) {
    if (appearance.presence(i) > 0) AddProp(frame, appearance.meshes()[i], reaches, bands);
  }
  return bands.Region();
}

}  // namespace kaori::passes
