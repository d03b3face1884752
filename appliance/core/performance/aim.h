// Where her eyes are in the stage, and how they must turn to look at a point of it.
#pragma once

#include <array>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"
#include "render/scene/scene.h"

namespace kaori::performance {

// Yaw and pitch, radians, of a direction: positive to her left and up, as scene::Gaze. A direction of no
// length is ahead.
glm::vec2 AnglesOf(glm::vec3 direction);
// The unit direction of such angles.
glm::vec3 DirectionOf(glm::vec2 angles_rad);

// The centres of the eyes of the face that is shown, with the head at rest: those of the called faces by
// their weights, or, where they show no balls, 63 mm apart.
std::array<glm::vec3, 2> EyesAtRest(const State& state, const show::Show& show);

// The head as it is turned in one frame. Points are of the stage (show::GazeTarget). Pure.
class HeadPose {
 public:
  // `eyes_m` with the head at rest; it turns about `pivot_m`.
  HeadPose(const scene::Head& head, const std::array<glm::vec3, 2>& eyes_m, glm::vec3 pivot_m);

  // Between both eyes.
  glm::vec3 middle_m() const { return middle_m_; }
  // How the eye, 0 the left, must turn in the head to look at the point.
  glm::vec2 EyeTo(std::size_t eye, glm::vec3 point_m) const;
  // The same as seen from between the eyes.
  glm::vec2 MiddleTo(glm::vec3 point_m) const;
  // The point straight ahead of the head, this far away.
  glm::vec3 Ahead(float distance_m) const;

 private:
  glm::vec2 InHead(glm::vec3 direction) const { return AnglesOf(glm::conjugate(turn_) * direction); }

  glm::quat turn_;
  std::array<glm::vec3, 2> eyes_m_;
  glm::vec3 middle_m_;
};

// How far two eyes that are turned so in such a head look past a point: the angle in radians, of both the larger.
float LooksPast_rad(const HeadPose& pose, const std::array<scene::Gaze, 2>& gaze, glm::vec3 point_m);

}  // namespace kaori::performance
