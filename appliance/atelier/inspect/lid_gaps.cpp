#include "appliance/atelier/inspect/lid_gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "appliance/atelier/inspect/depth_picture.h"

namespace kaori::inspect {
namespace {

constexpr int kPixels = 128;     // Across the ball: a fifth of a millimetre.
constexpr float kNearby = 2.5F;  // Lids lie within so many radii of the ball's middle.
constexpr int kGrazing = 2;      // So few pixels are a rim that the two rasters see differently.
constexpr std::array<float, 3> kYaws_rad{-0.5F, 0, 0.5F};
constexpr std::array<float, 3> kPitches_rad{-0.3F, 0, 0.3F};

using Triangles = std::vector<std::array<glm::vec3, 3>>;

Triangles Nearby(const face::EyeBall& ball, std::span<const glm::vec3> fine,
                 std::span<const face::Triangle> all) {
  const float reach_m = kNearby * ball.radius_m;
  Triangles nearby;
  for (const auto& [a, b, c] : all)
    if (glm::distance(fine[a], ball.centre) < reach_m) nearby.push_back({fine[a], fine[b], fine[c]});
  return nearby;
}

float SeenFrom_m2(const Sight& sight, const face::EyeBall& ball, const Triangles& triangles) {
  const glm::vec3 centre = Turned(ball.centre, sight);
  DepthPicture picture({glm::vec2(centre) - ball.radius_m, 2 * ball.radius_m}, kPixels);
  for (const auto& [a, b, c] : triangles) picture.Draw(Turned(a, sight), Turned(b, sight), Turned(c, sight));
  int seen = 0;
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      const glm::vec2 from = picture.Middle(x, y) - glm::vec2(centre);
      const float square = ball.radius_m * ball.radius_m - from.x * from.x - from.y * from.y;
      if (square > 0 && centre.z + std::sqrt(square) > picture.At(picture.Middle(x, y))) ++seen;
    }
  }
  const float pixel_m = 2 * ball.radius_m / kPixels;
  return seen <= kGrazing ? 0 : static_cast<float>(seen) * pixel_m * pixel_m;
}

}  // namespace

float BallSeen_m2(const face::EyeBall& ball, std::span<const glm::vec3> fine,
                  std::span<const face::Triangle> triangles) {
  if (!(ball.radius_m > 0)) return 0;
  const Triangles nearby = Nearby(ball, fine, triangles);
  float most_m2 = 0;
  for (const float yaw_rad : kYaws_rad)
    for (const float pitch_rad : kPitches_rad)
      most_m2 = std::max(most_m2, SeenFrom_m2({yaw_rad, pitch_rad}, ball, nearby));
  return most_m2;
}

}  // namespace kaori::inspect
