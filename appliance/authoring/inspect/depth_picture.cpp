#include "appliance/authoring/inspect/depth_picture.h"

#include <algorithm>
#include <cmath>

namespace kaori::inspect {
namespace {

// Farther back than any head.
constexpr float kNothing_m = -1e9F;
// A pixel on an edge belongs to both triangles: neighbours leave no pixel between them,
// whatever rounding says.
constexpr float kOnTheEdge = -1e-5F;

}  // namespace

glm::vec3 Turned(const glm::vec3& p, const View& view) {
  glm::vec3 turned;
  TurnAll({&p, 1}, view, {&turned, 1});
  return turned;
}

// Yaw: x' = x cos - z sin, z' = z cos + x sin. Pitch: y'' = y' cos - z' sin, z'' = y' sin + z' cos.
void TurnAll(std::span<const glm::vec3> points, const View& view, std::span<glm::vec3> turned) {
  const float cy = std::cos(view.yaw_rad);
  const float sy = std::sin(view.yaw_rad);
  const float cp = std::cos(view.pitch_rad);
  const float sp = std::sin(view.pitch_rad);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3& p = points[i];
    const glm::vec3 q{cy * p.x - sy * p.z, p.y, cy * p.z + sy * p.x};
    turned[i] = {q.x, cp * q.y - sp * q.z, sp * q.y + cp * q.z};
  }
}

Window WindowOver(std::span<const glm::vec3> points) {
  glm::vec2 low(1e9F);
  glm::vec2 high(-1e9F);
  for (const glm::vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  if (points.empty()) return {};
  // A single point has a window of a micrometre.
  return {low, std::max({high.x - low.x, high.y - low.y, 1e-6F})};
}

DepthPicture::DepthPicture(const Window& window, int pixels)
    : window_(window),
      pixels_(pixels),
      pixel_m_(window.size_m / static_cast<float>(pixels)),
      depth_(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels), kNothing_m) {}

glm::vec2 DepthPicture::Middle(int x, int y) const {
  return window_.low_m + pixel_m_ * glm::vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
}

float& DepthPicture::Pixel(int x, int y) {
  return depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels_) +
                static_cast<std::size_t>(x)];
}

// Clamped as floats: points far outside would not fit an int. A stretch beyond either edge gives
// first > last.
DepthPicture::Range DepthPicture::Span(float low, float high, float origin) const {
  const auto last = static_cast<float>(pixels_ - 1);
  return {static_cast<int>(std::clamp(std::floor((low - origin) / pixel_m_), 0.0F, last + 1)),
          static_cast<int>(std::clamp(std::ceil((high - origin) / pixel_m_), -1.0F, last))};
}

// Incremental edge functions along each row: this is the inner loop of all inspections.
void DepthPicture::Draw(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const Range columns = Span(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), window_.low_m.x);
  const Range rows = Span(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), window_.low_m.y);
  // Twice the area, signed: shares are the same for either winding.
  const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (area == 0 || columns.first > columns.last) return;
  // Shares of the corners a and b (edge functions, Pineda 1988), and their change from one pixel to the next.
  const float per_area = 1 / area;
  const float u_step = (b.y - c.y) * pixel_m_ * per_area;
  const float v_step = (c.y - a.y) * pixel_m_ * per_area;
  for (int y = rows.first; y <= rows.last; ++y) {
    const glm::vec2 p = Middle(columns.first, y);
    float u = ((b.x - p.x) * (c.y - p.y) - (b.y - p.y) * (c.x - p.x)) * per_area;
    float v = ((c.x - p.x) * (a.y - p.y) - (c.y - p.y) * (a.x - p.x)) * per_area;
    float* pixel = &Pixel(0, y);
    for (int x = columns.first; x <= columns.last; ++x, u += u_step, v += v_step) {
      const float w = 1 - u - v;
      if (u < kOnTheEdge || v < kOnTheEdge || w < kOnTheEdge) continue;
      pixel[x] = std::max(pixel[x], u * a.z + v * b.z + w * c.z);
    }
  }
}

// x^2 + y^2 + z^2 = r^2 about the centre, solved for the nearer z; nothing is drawn on the rim itself.
void DepthPicture::DrawBall(const glm::vec3& centre, float radius_m) {
  const Range columns = Span(centre.x - radius_m, centre.x + radius_m, window_.low_m.x);
  const Range rows = Span(centre.y - radius_m, centre.y + radius_m, window_.low_m.y);
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      const glm::vec2 from = Middle(x, y) - glm::vec2(centre);
      const float square = radius_m * radius_m - from.x * from.x - from.y * from.y;
      if (square > 0) Pixel(x, y) = std::max(Pixel(x, y), centre.z + std::sqrt(square));
    }
  }
}

// Cutting to whole numbers rounds down, since neither is below 0 by then.
float DepthPicture::At(const glm::vec2& position) const {
  const glm::vec2 at = (position - window_.low_m) / pixel_m_;
  const auto last = static_cast<float>(pixels_);
  // Written so that a position that is no number is outside, too.
  if (!(at.x >= 0 && at.x < last && at.y >= 0 && at.y < last)) return kNothing_m;
  return depth_[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(pixels_) +
                static_cast<std::size_t>(at.x)];
}

bool DepthPicture::Empty(const glm::vec2& position) const {
  return At(position) == kNothing_m;
}

}  // namespace kaori::inspect
