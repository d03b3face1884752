#include "appliance/authoring/appearance/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// Straight pieces that draw a bent stroke: hairs bend little.
constexpr int kPieces = 5;
constexpr float kSoftEdge_cm = 0.014F;  // About half a texel where the texture is finest.

using Bent = std::array<glm::vec2, kPieces + 1>;

// The quadratic Bézier at even steps of its parameter.
Bent Flatten(const Stroke& s) {
  Bent points{};
  for (int i = 0; i <= kPieces; ++i) {
    const float t = static_cast<float>(i) / kPieces;
    points[static_cast<std::size_t>(i)] =
        s.root_cm * ((1 - t) * (1 - t)) + s.bend_cm * (2 * t * (1 - t)) + s.tip_cm * (t * t);
  }
  return points;
}

// How near a line comes to a point, and where on it.
struct Nearest {
  float distance_cm = 1e9F;
  float along = 0;  // 0 at the root .. 1 at the tip.
};

// Over all straight pieces: the nearest point of each is the foot of the perpendicular, or an end.
Nearest NearestOn(const Bent& line, glm::vec2 p) {
  Nearest best;
  for (int i = 0; i < kPieces; ++i) {
    const glm::vec2 a = line[static_cast<std::size_t>(i)];
    const glm::vec2 d = line[static_cast<std::size_t>(i) + 1] - a;
    const float h = Clamp01(glm::dot(p - a, d) / std::max(glm::dot(d, d), 1e-9F));
    const float distance_cm = glm::length(p - a - d * h);
    if (distance_cm < best.distance_cm) best = {distance_cm, (static_cast<float>(i) + h) / kPieces};
  }
  return best;
}

// How opaque the stroke is at this distance: narrower towards the tip, by the square of the way, and fading
// out in its last part.
float Coverage(const Stroke& stroke, Nearest n) {
  const float half_cm = stroke.half_width_cm * (1 - 0.85F * n.along * n.along);
  return stroke.opacity * SmoothStep(half_cm + kSoftEdge_cm, half_cm - kSoftEdge_cm, n.distance_cm) *
         (1 - SmoothStep(0.85F, 1, n.along));
}

// Row-major; what lies outside counts as the nearest inside.
// Rows from the top, as the atlas has its texels.
std::size_t IndexOf(long x, long y, int size_px) {
  const auto inside = [size_px](long v) { return static_cast<std::size_t>(std::clamp(v, 0L, size_px - 1L)); };
  return inside(y) * static_cast<std::size_t>(size_px) + inside(x);
}

// No hair hangs into the mouth.
bool InMouth(const Texel& texel) {
  return texel.bag > 0.05F;
}

// Texels from (x0, y0) to (x1, y1), both included.
struct Box {
  int x0, y0, x1, y1;
};

// The map to the texture is monotone in each axis, so the corners of the stroke's box give those in texels.
Box BoxOf(const Stroke& s, int size_px) {
  const float margin_cm = s.half_width_cm + kSoftEdge_cm;
  const glm::vec2 low = glm::min(glm::min(s.root_cm, s.tip_cm), s.bend_cm) - margin_cm;
  const glm::vec2 high = glm::max(glm::max(s.root_cm, s.tip_cm), s.bend_cm) + margin_cm;
  const glm::vec2 top_left = TexelFromUv({low.x, high.y}, size_px);
  const glm::vec2 bottom_right = TexelFromUv({high.x, low.y}, size_px);
  const auto clip = [size_px](float v) { return std::clamp(static_cast<int>(v), 0, size_px - 1); };
  return {clip(top_left.x), clip(top_left.y), clip(bottom_right.x + 1), clip(bottom_right.y + 1)};
}

// The texels above, below and beside one, as many as there are. To be walked by a range-for.
class Around {
 public:
  Around(std::size_t texel, int size_px) {
    const auto size = static_cast<std::size_t>(size_px);
    if (texel % size > 0) Add(texel - 1);
    if (texel % size + 1 < size) Add(texel + 1);
    if (texel / size > 0) Add(texel - size);
    if (texel / size + 1 < size) Add(texel + size);
  }
  const std::size_t* begin() const { return texels_.data(); }
  const std::size_t* end() const { return texels_.data() + count_; }

 private:
  void Add(std::size_t texel) { texels_[count_++] = texel; }

  std::array<std::size_t, 4> texels_{};
  std::size_t count_ = 0;
};

// The texels beside a wave that nobody has filled, each once.
std::vector<std::size_t> NextWave(const std::vector<std::size_t>& wave,
                                  const std::vector<std::uint8_t>& filled, int size_px) {
  std::vector<std::size_t> next;
  for (const std::size_t i : wave) {
    for (const std::size_t n : Around(i, size_px)) {
      if (filled[n] == 0) next.push_back(n);
    }
  }
  std::sort(next.begin(), next.end());
  next.erase(std::unique(next.begin(), next.end()), next.end());
  return next;
}

}  // namespace

// In linear light: a mean of sRGB bytes would be too dark.
void Paint::Mix(float amount, glm::vec3 over) {
  const float a = Clamp01(amount);
  colour = colour * (1 - a) + over * a;
}

void Paint::MixGloss(float amount, float over) {
  const float a = Clamp01(amount);
  gloss = gloss * (1 - a) + over * a;
}

// Nearest texel; what is painted there so far.
glm::vec3 Canvas::Sample(glm::vec2 uv_cm) const {
  const glm::vec2 at = TexelFromUv(uv_cm, atlas_.size_px);
  return texels_[IndexOf(std::lround(at.x), std::lround(at.y), atlas_.size_px)].colour;
}

// Every texel of the box is asked how near the bent line is.
void Canvas::Draw(const Stroke& stroke) {
  const Bent line = Flatten(stroke);
  const Box box = BoxOf(stroke, atlas_.size_px);
  for (int y = box.y0; y <= box.y1; ++y) {
    for (int x = box.x0; x <= box.x1; ++x) {
      const std::size_t i = IndexOf(x, y, atlas_.size_px);
      const Nearest nearest = NearestOn(line, atlas_.texels[i].uv_cm);
      // Strokes are judged by uv, not by texels: texels differ in size over the surface.
      if (nearest.distance_cm > stroke.half_width_cm + kSoftEdge_cm || InMouth(atlas_.texels[i])) continue;
      texels_[i].Mix(Coverage(stroke, nearest), stroke.colour);
    }
  }
}

// Only neighbours of earlier waves: those of this one are not marked yet.
void Canvas::FillFrom(std::size_t texel, const std::vector<std::uint8_t>& filled) {
  Paint sum;
  float count = 0;
  for (const std::size_t n : Around(texel, atlas_.size_px)) {
    if (filled[n] == 0) continue;
    sum.colour += texels_[n].colour;
    sum.gloss += texels_[n].gloss;
    ++count;
  }
  texels_[texel] = {sum.colour / count, sum.gloss / count};
}

// Wave by wave from the edges of what is covered: each texel outside takes the mean of its neighbours that
// were filled by earlier waves.
void Canvas::FillOutside() {
  std::vector<std::uint8_t> filled(texels_.size());
  std::vector<std::size_t> wave;
  for (std::size_t i = 0; i < filled.size(); ++i) {
    filled[i] = atlas_.texels[i].covered ? 1 : 0;
    if (filled[i] == 1) wave.push_back(i);
  }
  while (!wave.empty()) {
    wave = NextWave(wave, filled, atlas_.size_px);
    for (const std::size_t i : wave) FillFrom(i, filled);
    for (const std::size_t i : wave) filled[i] = 1;
  }
}

// Gloss is linear, 0..255.
face::Texture Canvas::Finish() && {
  FillOutside();
  std::vector<std::uint8_t> rgba;
  rgba.reserve(texels_.size() * 4);
  for (const Paint& p : texels_) {
    rgba.push_back(ToSrgbByte(p.colour.r));
    rgba.push_back(ToSrgbByte(p.colour.g));
    rgba.push_back(ToSrgbByte(p.colour.b));
    rgba.push_back(static_cast<std::uint8_t>(std::lround(Clamp01(p.gloss) * 255)));
  }
  return {atlas_.size_px, atlas_.size_px, std::move(rgba)};
}

}  // namespace kaori::appearance
