#include "appliance/atelier/inspect/lid_gaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "appliance/atelier/inspect/depth_picture.h"

namespace kaori::inspect {
namespace {

constexpr int kPixels = 96;  // Across the ball: half a millimetre.
constexpr int kGrazing = 2;  // So few pixels are a rim that the two rasters see differently.
constexpr std::array<float, 3> kYaws_rad{-0.5F, 0, 0.5F};
constexpr std::array<float, 3> kPitches_rad{-0.3F, 0, 0.3F};

float PixelsOfBall(const DepthPicture& picture, const glm::vec3& centre, float radius_m) {
  int seen = 0;
  for (int y = 0; y < picture.pixels(); ++y) {
    for (int x = 0; x < picture.pixels(); ++x) {
      const glm::vec2 place = picture.Middle(x, y);
      const glm::vec2 from = place - glm::vec2(centre);
      const float square = radius_m * radius_m - from.x * from.x - from.y * from.y;
      if (square > 0 && centre.z + std::sqrt(square) > picture.At(place)) ++seen;
    }
  }
  return seen <= kGrazing ? 0 : static_cast<float>(seen);
}

// `turned` are all vertices, and `centre` the ball's, in the frame of the sight.
float BallSeen_m2(const glm::vec3& centre, float radius_m, std::span<const glm::vec3> turned,
                  std::span<const face::Triangle> triangles) {
  if (!(radius_m > 0)) return 0;
  DepthPicture picture({glm::vec2(centre) - radius_m, 2 * radius_m}, kPixels);
  for (const auto& [a, b, c] : triangles) picture.Draw(turned[a], turned[b], turned[c]);
  const float pixel_m = 2 * radius_m / kPixels;
  return PixelsOfBall(picture, centre, radius_m) * pixel_m * pixel_m;
}

}  // namespace

std::array<float, 2> BallsSeen_m2(const face::Shape& shape, std::span<const face::Triangle> triangles) {
  std::array<float, 2> most_m2{};
  std::vector<glm::vec3> turned(shape.fine.size());
  for (const float yaw_rad : kYaws_rad) {
    for (const float pitch_rad : kPitches_rad) {
      const Sight sight{yaw_rad, pitch_rad};
      TurnAll(shape.fine, sight, turned);
      for (std::size_t side = 0; side < 2; ++side) {
        const face::EyeBall& eye = shape.eyes[side];
        const float seen_m2 = BallSeen_m2(Turned(eye.centre, sight), eye.radius_m, turned, triangles);
        most_m2[side] = std::max(most_m2[side], seen_m2);
      }
    }
  }
  return most_m2;
}

}  // namespace kaori::inspect
