#include "appliance/authoring/inspect/skin.h"

#include <array>

#include <glm/geometric.hpp>

#include "appliance/authoring/inspect/depth_picture.h"

namespace kaori::inspect {
namespace {

// Half a millimetre for a head of 25 cm.
constexpr int kSkinPixels = 512;
constexpr float kBehind_m =
    0.0007F;  // Hardly more than a pixel: what lies this far behind the nearest is seen.
// The front, both three-quarter views and profiles, and a little from above and below: from where audiences
// see a head.
constexpr std::array<View, 7> kViews{
    {{0, 0}, {-0.7F, 0}, {0.7F, 0}, {-1.4F, 0}, {1.4F, 0}, {0, 0.4F}, {0, -0.4F}}};

// Marks the triangles whose middle is seen from one side and whose front looks there.
void AddSeen(const face::Shape& shape, std::span<const face::Triangle> triangles, const View& view,
             std::vector<bool>& seen) {
  std::vector<glm::vec3> turned(shape.fine.size());
  TurnAll(shape.fine, view, turned);
  DepthPicture picture(WindowOver(turned), kSkinPixels);
  for (const face::Triangle& t : triangles) picture.Draw(turned[t[0]], turned[t[1]], turned[t[2]]);
  // Without the balls the inside of the lids would be seen through the eyes' openings.
  for (const face::EyeBall& eye : shape.eyes) picture.DrawBall(Turned(eye.centre, view), eye.radius_m);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    const glm::vec3 middle = (turned[a] + turned[b] + turned[c]) / 3.0F;
    const bool faces_us = glm::cross(turned[b] - turned[a], turned[c] - turned[a]).z > 0;
    if (faces_us && middle.z > picture.At(middle) - kBehind_m) seen[i] = true;
  }
}

}  // namespace

// Seen from any side is enough. Hair and clothes are not drawn: what lies beneath them is skin as well.
std::vector<bool> FindSkin(const face::Shape& at_rest, std::span<const face::Triangle> triangles) {
  std::vector<bool> seen(triangles.size(), false);
  for (const View& view : kViews) AddSeen(at_rest, triangles, view, seen);
  return seen;
}

}  // namespace kaori::inspect
