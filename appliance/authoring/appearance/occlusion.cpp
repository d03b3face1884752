#include "appliance/authoring/appearance/occlusion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// Directions evenly over the sphere: a spiral by the golden angle, pi (3 - sqrt 5).
glm::vec3 SphereDirection(int i, int count) {
  const float y = 1 - 2 * (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
  const float r = std::sqrt(1 - y * y);
  const float a = 2.39996323F * static_cast<float>(i);
  return {r * std::cos(a), y, r * std::sin(a)};
}

// A depth picture seen from far away along -`to_light`; larger is nearer to the light. Orthographic, since
// the light comes from afar: x and y span the picture, z points to the light. All in metres before Project,
// in pixels and metres of depth after it.
class DepthPicture {
 public:
  DepthPicture(glm::vec3 to_light, const OcclusionSettings& settings)
      : size_(settings.picture_px),
        z_(to_light),
        // Any axis across the light; the fixed vector is parallel to none of the directions.
        x_(glm::normalize(glm::cross(to_light, glm::vec3(0.3F, 0.8F, 0.5F)))),
        y_(glm::cross(to_light, x_)),
        depth_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_),
               -std::numeric_limits<float>::infinity()) {
    const glm::vec3 middle = (settings.low_m + settings.high_m) * 0.5F;
    const float reach = glm::length(settings.high_m - settings.low_m) * 0.5F;
    scale_ = static_cast<float>(size_) * 0.5F / reach;
    origin_ = glm::vec2(glm::dot(middle, x_), glm::dot(middle, y_)) - reach;
  }

  glm::vec3 Project(glm::vec3 p) const {
    return {(glm::dot(p, x_) - origin_.x) * scale_, (glm::dot(p, y_) - origin_.y) * scale_, glm::dot(p, z_)};
  }

  // Triangles of either winding, in projected coordinates; a pixel counts by its middle.
  void Draw(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (std::abs(area) < 1e-9F) return;
    const auto [x_low, x_high] = std::minmax({a.x, b.x, c.x});
    const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
    for (int y = Clip(y_low); y <= Clip(y_high); ++y) {
      for (int x = Clip(x_low); x <= Clip(x_high); ++x) {
        const float px = static_cast<float>(x) + 0.5F;
        const float py = static_cast<float>(y) + 0.5F;
        const float u = ((c.x - b.x) * (py - b.y) - (c.y - b.y) * (px - b.x)) / area;
        const float v = ((a.x - c.x) * (py - c.y) - (a.y - c.y) * (px - c.x)) / area;
        const float w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        float& depth = depth_[At(x, y)];
        depth = std::max(depth, u * a.z + v * b.z + w * c.z);
      }
    }
  }

  // The nearest depth to the light at a projected point; nothing there: minus infinity.
  float DepthAt(glm::vec3 projected) const {
    const int x = static_cast<int>(std::floor(projected.x));
    const int y = static_cast<int>(std::floor(projected.y));
    if (x < 0 || y < 0 || x >= size_ || y >= size_) return -std::numeric_limits<float>::infinity();
    return depth_[At(x, y)];
  }

 private:
  int Clip(float v) const { return std::clamp(static_cast<int>(v), 0, size_ - 1); }
  std::size_t At(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(x);
  }

  int size_;
  glm::vec3 z_, x_, y_;
  glm::vec2 origin_{};
  float scale_ = 1;
  std::vector<float> depth_;
};

// Props reach far below the picture's edge; what lies there costs pixels and shades nothing that is seen.
bool Inside(const glm::vec3& p, const OcclusionSettings& s) {
  return p.x > s.low_m.x && p.y > s.low_m.y && p.z > s.low_m.z && p.x < s.high_m.x && p.y < s.high_m.y &&
         p.z < s.high_m.z;
}

// With a corner in the box.
std::vector<face::Triangle> TrianglesInside(const Shell& shell, const OcclusionSettings& settings) {
  std::vector<face::Triangle> inside;
  for (const face::Triangle& t : shell.triangles) {
    const bool any =
        std::any_of(t.begin(), t.end(), [&](face::Index i) { return Inside(shell.positions[i], settings); });
    if (any) inside.push_back(t);
  }
  return inside;
}

}  // namespace

// The integral of visibility times the cosine over the hemisphere of each normal, divided by that of the
// cosine alone: ambient occlusion as in Zhukov et al. 1998. Each direction is one depth picture of the whole
// figure, in which all probes are looked up. A probe is lifted off its surface twice, along the normal and in
// depth, or surfaces would shade themselves by the picture's pixels.
std::vector<float> MeasureOpenness(const Shell& shell, const std::vector<Probe>& probes,
                                   const OcclusionSettings& settings) {
  const std::vector<face::Triangle> triangles = TrianglesInside(shell, settings);
  std::vector<float> seen(probes.size(), 0);
  // Not 0, for a probe that no direction lies before.
  std::vector<float> total(probes.size(), 1e-6F);
  std::vector<glm::vec3> projected(shell.positions.size());
  for (int i = 0; i < settings.directions; ++i) {
    const glm::vec3 to_light = SphereDirection(i, settings.directions);
    DepthPicture picture(to_light, settings);
    for (std::size_t v = 0; v < projected.size(); ++v) projected[v] = picture.Project(shell.positions[v]);
    for (const face::Triangle& t : triangles) picture.Draw(projected[t[0]], projected[t[1]], projected[t[2]]);
    for (std::size_t p = 0; p < probes.size(); ++p) {
      const float weight = glm::dot(probes[p].normal, to_light);
      if (weight <= 0) continue;
      total[p] += weight;
      const glm::vec3 at = picture.Project(probes[p].position + probes[p].normal * probes[p].lift_m);
      if (picture.DepthAt(at) < at.z + probes[p].lift_m) seen[p] += weight;
    }
  }
  for (std::size_t p = 0; p < probes.size(); ++p) seen[p] = Clamp01(seen[p] / total[p]);
  return seen;
}

// Half its own value, half the mean of its neighbours over triangles' edges; an edge that two triangles share
// counts twice.
void SmoothOver(const std::vector<face::Triangle>& triangles, int steps, std::vector<float>& values) {
  std::vector<float> sum(values.size());
  std::vector<float> count(values.size());
  for (int step = 0; step < steps; ++step) {
    std::fill(sum.begin(), sum.end(), 0.0F);
    std::fill(count.begin(), count.end(), 0.0F);
    for (const face::Triangle& t : triangles) {
      for (std::size_t c = 0; c < 3; ++c) {
        sum[t[c]] += values[t[(c + 1) % 3]] + values[t[(c + 2) % 3]];
        count[t[c]] += 2;
      }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (count[i] > 0) values[i] = 0.5F * values[i] + 0.5F * sum[i] / count[i];
    }
  }
}

// Weighted by the triangles' areas, as the cross product comes; 1e6 keeps areas of square millimetres away
// from a float's small end.
std::vector<glm::vec3> VertexNormals(const std::vector<glm::vec3>& positions,
                                     const std::vector<face::Triangle>& triangles) {
  std::vector<glm::vec3> normals(positions.size());
  for (const face::Triangle& t : triangles) {
    const glm::vec3 area = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (const face::Index i : t) normals[i] += area * 1e6F;
  }
  for (glm::vec3& n : normals) n = glm::length(n) > 0 ? glm::normalize(n) : glm::vec3(0, 0, 1);
  return normals;
}

}  // namespace kaori::appearance
