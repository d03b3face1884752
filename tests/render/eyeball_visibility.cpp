#include "tests/render/eyeball_visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kaori::tests {
namespace {

constexpr int kPixels = 160;  // Across the ball.

glm::vec3 Turned(const glm::vec3& p, const ViewAngle& angle) {
  const float cy = std::cos(angle.yaw_rad);
  const float sy = std::sin(angle.yaw_rad);
  const float cp = std::cos(-angle.pitch_rad);
  const float sp = std::sin(-angle.pitch_rad);
  const glm::vec3 q{cy * p.x + sy * p.z, p.y, cy * p.z - sy * p.x};
  return {q.x, cp * q.y - sp * q.z, sp * q.y + cp * q.z};
}

// Depths on a square grid over the ball.
class DepthMap {
 public:
  DepthMap(const glm::vec3& centre, float radius_m)
      : corner_(centre - glm::vec3(radius_m, radius_m, 0)), pixel_m_(2 * radius_m / kPixels) {}

  glm::vec2 Middle(int x, int y) const {
    return {corner_.x + (static_cast<float>(x) + 0.5F) * pixel_m_,
            corner_.y + (static_cast<float>(y) + 0.5F) * pixel_m_};
  }
  float At(int x, int y) const { return depth_[static_cast<std::size_t>(y * kPixels + x)]; }
  float pixel_m2() const { return pixel_m_ * pixel_m_; }

  void Draw(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0) return;
    const auto [left, right] = Range(a.x, b.x, c.x, corner_.x);
    const auto [low, high] = Range(a.y, b.y, c.y, corner_.y);
    for (int y = low; y <= high; ++y) {
      for (int x = left; x <= right; ++x) {
        const glm::vec2 p = Middle(x, y);
        const float u = ((b.x - p.x) * (c.y - p.y) - (b.y - p.y) * (c.x - p.x)) / area;
        const float v = ((c.x - p.x) * (a.y - p.y) - (c.y - p.y) * (a.x - p.x)) / area;
        const float w = 1 - u - v;
        if (std::min({u, v, w}) < -1e-5F) continue;
        float& depth = depth_[static_cast<std::size_t>(y * kPixels + x)];
        depth = std::max(depth, u * a.z + v * b.z + w * c.z);
      }
    }
  }

 private:
  // The pixels that three coordinates span.
  std::pair<int, int> Range(float a, float b, float c, float corner) const {
    const float low = (std::min({a, b, c}) - corner) / pixel_m_;
    const float high = (std::max({a, b, c}) - corner) / pixel_m_;
    return {static_cast<int>(std::clamp(std::floor(low), 0.0F, float{kPixels})),
            static_cast<int>(std::clamp(std::ceil(high), -1.0F, float{kPixels - 1}))};
  }

  glm::vec3 corner_;
  float pixel_m_;
  std::vector<float> depth_ = std::vector<float>(kPixels * kPixels, -std::numeric_limits<float>::max());
};

}  // namespace

float BallSeen_m2(const face::EyeBall& ball, const Surface& surface, const ViewAngle& angle) {
  const glm::vec3 centre = Turned(ball.centre, angle);
  DepthMap map(centre, ball.radius_m);
  std::vector<glm::vec3> turned;
  for (const glm::vec3& p : surface.positions) turned.push_back(Turned(p, angle));
  for (const face::Triangle& t : surface.triangles) map.Draw(turned[t[0]], turned[t[1]], turned[t[2]]);
  int seen = 0;
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      const glm::vec2 from = map.Middle(x, y) - glm::vec2(centre);
      const float square = ball.radius_m * ball.radius_m - from.x * from.x - from.y * from.y;
      if (square > 0 && centre.z + std::sqrt(square) > map.At(x, y)) ++seen;
    }
  }
  return static_cast<float>(seen) * map.pixel_m2();
}

}  // namespace kaori::tests
