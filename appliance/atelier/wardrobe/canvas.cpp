#include "appliance/atelier/wardrobe/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/atelier/wardrobe/colour.h"
#include "appliance/atelier/wardrobe/shaping.h"

namespace kaori::wardrobe {
namespace {

constexpr int kPieces = 5;              // Straight pieces that draw a bent stroke.
constexpr float kSoftEdge_cm = 0.014F;  // About half a texel where the texture is finest.

using Bent = std::array<glm::vec2, kPieces + 1>;

Bent Flatten(const Stroke& s) {
  Bent points{};
  for (int i = 0; i <= kPieces; ++i) {
    const float t = static_cast<float>(i) / kPieces;
    points[static_cast<std::size_t>(i)] =
        s.root_cm * ((1 - t) * (1 - t)) + s.bend_cm * (2 * t * (1 - t)) + s.tip_cm * (t * t);
  }
  return points;
}

struct Nearest {
  float distance_cm = 1e9F;
  float along = 0;  // 0 at the root .. 1 at the tip.
};

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

float Coverage(const Stroke& stroke, Nearest n) {
  const float half_cm = stroke.half_width_cm * (1 - 0.85F * n.along * n.along);
  return stroke.opacity * SmoothStep(half_cm + kSoftEdge_cm, half_cm - kSoftEdge_cm, n.distance_cm) *
         (1 - SmoothStep(0.85F, 1, n.along));
}

struct Box {
  int x0, y0, x1, y1;
};

Box BoxOf(const Stroke& s, int size_px) {
  const float margin_cm = s.half_width_cm + kSoftEdge_cm;
  const glm::vec2 low = glm::min(glm::min(s.root_cm, s.tip_cm), s.bend_cm) - margin_cm;
  const glm::vec2 high = glm::max(glm::max(s.root_cm, s.tip_cm), s.bend_cm) + margin_cm;
  const glm::vec2 top_left = TexelFromPlace({low.x, high.y}, size_px);
  const glm::vec2 bottom_right = TexelFromPlace({high.x, low.y}, size_px);
  const auto clip = [size_px](float v) { return std::clamp(static_cast<int>(v), 0, size_px - 1); };
  return {clip(top_left.x), clip(top_left.y), clip(bottom_right.x + 1), clip(bottom_right.y + 1)};
}

}  // namespace

void Paint::Mix(float amount, glm::vec3 over) {
  const float a = Clamp01(amount);
  colour = colour * (1 - a) + over * a;
}

void Paint::MixGloss(float amount, float over) {
  const float a = Clamp01(amount);
  gloss = gloss * (1 - a) + over * a;
}

glm::vec3 Canvas::Sample(glm::vec2 place_cm) const {
  const glm::vec2 at = TexelFromPlace(place_cm, atlas_.size_px);
  const int x = std::clamp(static_cast<int>(at.x + 0.5F), 0, atlas_.size_px - 1);
  const int y = std::clamp(static_cast<int>(at.y + 0.5F), 0, atlas_.size_px - 1);
  return texels_[static_cast<std::size_t>(y * atlas_.size_px + x)].colour;
}

void Canvas::Draw(const Stroke& stroke) {
  const Bent line = Flatten(stroke);
  const Box box = BoxOf(stroke, atlas_.size_px);
  for (int y = box.y0; y <= box.y1; ++y) {
    for (int x = box.x0; x <= box.x1; ++x) {
      const auto i = static_cast<std::size_t>(y * atlas_.size_px + x);
      const Nearest nearest = NearestOn(line, atlas_.texels[i].place_cm);
      if (nearest.distance_cm > stroke.half_width_cm + kSoftEdge_cm) continue;
      texels_[i].Mix(Coverage(stroke, nearest), stroke.colour);
    }
  }
}

// Breadth first from the edges of what is covered: every texel outside takes the mean of its neighbours that
// were filled before it.
void Canvas::FillOutside() {
  const int size = atlas_.size_px;
  std::vector<std::uint8_t> filled(texels_.size());
  for (std::size_t i = 0; i < filled.size(); ++i) filled[i] = atlas_.texels[i].covered ? 1 : 0;
  std::vector<int> wave;
  const auto inside = [size](int x, int y) { return x >= 0 && y >= 0 && x < size && y < size; };
  constexpr std::array<std::array<int, 2>, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const auto each_neighbour = [&](int i, auto&& visit) {
    for (const auto& step : kSteps) {
      if (inside(i % size + step[0], i / size + step[1]))
        visit(static_cast<std::size_t>(i + step[0] + step[1] * size));
    }
  };
  for (int i = 0; i < size * size; ++i) {
    if (filled[static_cast<std::size_t>(i)] == 1) wave.push_back(i);
  }
  while (!wave.empty()) {
    std::vector<int> next;
    for (const int i : wave) {
      each_neighbour(i, [&](std::size_t n) {
        if (filled[n] == 0) next.push_back(static_cast<int>(n));
        if (filled[n] == 0) filled[n] = 2;
      });
    }
    for (const int i : next) {
      Paint sum;
      float count = 0;
      each_neighbour(i, [&](std::size_t n) {
        if (filled[n] != 1) return;
        sum.colour += texels_[n].colour;
        sum.gloss += texels_[n].gloss;
        ++count;
      });
      texels_[static_cast<std::size_t>(i)] = {sum.colour / count, sum.gloss / count};
    }
    for (const int i : next) filled[static_cast<std::size_t>(i)] = 1;
    wave = std::move(next);
  }
}

face::Texture Canvas::Finish() && {
  FillOutside();
  face::Texture texture{atlas_.size_px, atlas_.size_px, {}};
  texture.rgba.reserve(texels_.size() * 4);
  for (const Paint& p : texels_) {
    texture.rgba.push_back(ToSrgbByte(p.colour.r));
    texture.rgba.push_back(ToSrgbByte(p.colour.g));
    texture.rgba.push_back(ToSrgbByte(p.colour.b));
    texture.rgba.push_back(static_cast<std::uint8_t>(std::lround(Clamp01(p.gloss) * 255)));
  }
  return texture;
}

}  // namespace kaori::wardrobe
