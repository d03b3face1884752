#include "appliance/authoring/inspect/lid_gaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "appliance/authoring/inspect/depth_picture.h"

namespace kaori::inspect {
namespace {

// Across the ball: about half a millimetre each, for an eyeball of 22 mm radius.
constexpr int kPixels = 96;
// For three sides, in the many poses.
constexpr int kFewerPixels = 64;
// So few pixels are a rim that the two rasters (ball and triangles) see differently.
constexpr int kGrazing = 2;
// Radii from the ball's centre within which lids lie.
constexpr float kClose = 1.4F;
// How far to the sides, and above and below, an audience sits.
constexpr std::array<float, 3> kYaws_rad{-0.5F, 0, 0.5F};
constexpr std::array<float, 3> kPitches_rad{-0.3F, 0, 0.3F};

// Pixels in which the ball lies before all that was drawn.
float PixelsOfBall(const DepthPicture& picture, const glm::vec3& centre, float radius_m) {
  int seen = 0;
  for (int y = 0; y < picture.pixels(); ++y) {
    for (int x = 0; x < picture.pixels(); ++x) {
      const glm::vec2 position = picture.Middle(x, y);
      const glm::vec2 from = position - glm::vec2(centre);
      const float square = radius_m * radius_m - from.x * from.x - from.y * from.y;
      if (square > 0 && centre.z + std::sqrt(square) > picture.At(position)) ++seen;
    }
  }
  return seen <= kGrazing ? 0 : static_cast<float>(seen);
}

// Three corners each, one after the other, so that they are turned in one go.
using Triangles = std::vector<glm::vec3>;  // Three corners each.

// The triangles that cover a ball closely: all their corners outside it and within kClose radii.
Triangles CloseTo(const face::EyeBall& eye, const face::Shape& shape,
                  std::span<const face::Triangle> triangles) {
  const float reach_m = kClose * eye.radius_m;
  const auto covers = [&](face::Index v) {
    const glm::vec3 from = shape.fine[v] - eye.centre;
    const float square = glm::dot(from, from);
    return square > eye.radius_m * eye.radius_m && square < reach_m * reach_m;
  };
  Triangles corners;
  for (const face::Triangle& t : triangles)
    if (std::ranges::all_of(t, covers))
      for (const face::Index v : t) corners.push_back(shape.fine[v]);
  return corners;
}

// Of the whole head.
Triangles All(const face::Shape& shape, std::span<const face::Triangle> triangles) {
  Triangles corners;
  corners.reserve(3 * triangles.size());
  for (const face::Triangle& t : triangles)
    for (const face::Index v : t) corners.push_back(shape.fine[v]);
  return corners;
}

// Counter-clockwise in the picture's plane.
bool FacesUs(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
}

// One side's picture of one ball.
struct Look {
  View view;
  DepthPicture picture;
  glm::vec3 centre;  // The ball's, in the frame of the view.
};

// The window is just the ball.
std::vector<Look> LooksAt(const face::EyeBall& eye, Sides sides) {
  std::vector<Look> looks;
  for (const float yaw_rad : kYaws_rad) {
    for (const float pitch_rad : kPitches_rad) {
      if (sides == Sides::kThree && pitch_rad != 0) continue;
      const View view{yaw_rad, pitch_rad};
      const glm::vec3 centre = Turned(eye.centre, view);
      const Window window{glm::vec2(centre) - eye.radius_m, 2 * eye.radius_m};
      looks.push_back({view, DepthPicture(window, sides == Sides::kNine ? kPixels : kFewerPixels), centre});
    }
  }
  return looks;
}

// Draws `corners` over what has been drawn before, and tells the most that is still seen from any
// side, square metres. What lies behind the ball's middle is left out; `front_alone` leaves out what
// looks away, too.
float BallSeen_m2(std::vector<Look>& looks, float radius_m, const Triangles& corners, bool front_alone) {
  float most_m2 = 0;
  Triangles turned(corners.size());
  for (Look& look : looks) {
    TurnAll(corners, look.view, turned);
    for (std::size_t i = 0; i < turned.size(); i += 3) {
      const glm::vec3 &a = turned[i], &b = turned[i + 1], &c = turned[i + 2];
      if (std::max({a.z, b.z, c.z}) < look.centre.z || (front_alone && !FacesUs(a, b, c))) continue;
      look.picture.Draw(a, b, c);
    }
    const float pixel_m = 2 * radius_m / static_cast<float>(look.picture.pixels());
    most_m2 = std::max(most_m2, PixelsOfBall(look.picture, look.centre, radius_m) * pixel_m * pixel_m);
  }
  return most_m2;
}

}  // namespace

// A face that shows no ball has one without a radius, which has no gap.
std::array<float, 2> BallsSeen_m2(const face::Shape& shape, std::span<const face::Triangle> triangles,
                                  Sides sides) {
  std::array<float, 2> seen_m2{};
  for (std::size_t side = 0; side < 2; ++side) {
    const face::EyeBall& eye = shape.eyes[side];
    if (!(eye.radius_m > 0)) continue;
    std::vector<Look> looks = LooksAt(eye, sides);
    // Mostly the lids hide all; the rest of the head (a nose, a brow) is drawn only if they do not.
    seen_m2[side] = BallSeen_m2(looks, eye.radius_m, CloseTo(eye, shape, triangles), true);
    if (seen_m2[side] > 0) seen_m2[side] = BallSeen_m2(looks, eye.radius_m, All(shape, triangles), false);
  }
  return seen_m2;
}

}  // namespace kaori::inspect
