#include "render/scene/view.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace kaori::scene {
namespace {

// How far before and behind the camera's target anything is drawn.
constexpr float kReach_m = 0.45F;

// A point this near to the camera's plane, or behind it, has no position in the picture.
constexpr float kNearest = 1e-3F;

}  // namespace

// Rotations about +X turn the face down and about +Z to the right shoulder, hence the signs.
glm::quat TurnOf(const Head& head) {
  return glm::angleAxis(head.yaw_rad, glm::vec3(0, 1, 0)) *
         glm::angleAxis(-head.pitch_rad, glm::vec3(1, 0, 0)) *
         glm::angleAxis(-head.roll_rad, glm::vec3(0, 0, 1));
}

// Spherical coordinates about the target; the camera keeps +Y up.
glm::mat4 ViewOf(const Camera& camera) {
  const float level = std::cos(camera.height_rad);
  const glm::vec3 away{std::sin(camera.yaw_rad) * level, std::sin(camera.height_rad),
                       std::cos(camera.yaw_rad) * level};
  return glm::lookAt(camera.target_m + away * camera.distance_m, camera.target_m, glm::vec3(0, 1, 0));
}

glm::mat4 ProjectionOf(const Camera& camera, float aspect) {
  const float near_m = std::max(camera.distance_m - kReach_m, 0.02F);
  return glm::perspective(camera.field_of_view_rad, aspect, near_m, camera.distance_m + kReach_m);
}

View::View(const Scene& scene, glm::vec3 pivot_m, float aspect)
    : turn_(TurnOf(scene.head)),
      pivot_m_(pivot_m),
      shift_m_(scene.head.shift_m),
      view_(ViewOf(scene.camera)),
      projection_(ProjectionOf(scene.camera, aspect)) {}

// The head turns about the pivot and is shifted afterwards, along the axes of the world.
glm::vec3 View::Turned(glm::vec3 point_m) const {
  return turn_ * (point_m - pivot_m_) + pivot_m_ + shift_m_;
}

glm::vec2 View::InPicture(glm::vec3 point_m) const {
  const glm::vec4 clip = projection_ * view_ * glm::vec4(Turned(point_m), 1);
  return glm::vec2(clip) / std::max(clip.w, kNearest);
}

// A step of the picture, made a step in the camera's plane at the point's depth, and turned back into the
// head's frame.
glm::vec3 View::AtDepthOf(glm::vec3 point_m, glm::vec2 step) const {
  const float depth_m = std::max(-(view_ * glm::vec4(Turned(point_m), 1)).z, kNearest);
  const glm::vec3 seen{step.x * depth_m / projection_[0][0], step.y * depth_m / projection_[1][1], 0};
  return glm::inverse(turn_) * (glm::transpose(glm::mat3(view_)) * seen);
}

// Against the ray to the point, not against the camera's axis: at the edge of the picture they differ.
bool View::Faces(glm::vec3 point_m, glm::vec3 normal) const {
  const glm::mat3 axes(view_);
  const glm::vec3 seen_m(view_ * glm::vec4(Turned(point_m), 1));
  return glm::dot(axes * (turn_ * normal), seen_m) < 0;
}

}  // namespace kaori::scene
