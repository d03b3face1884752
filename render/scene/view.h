// Where things of a scene stand in its picture: the camera, and the turn of the head.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/scene/scene.h"

namespace kaori::scene {

// The rotation of a head from its rest to its pose, without its shift. A unit quaternion.
glm::quat TurnOf(const Head& head);

// World to camera: the camera at the origin, +X right, +Y up, -Z where it looks. Metres.
glm::mat4 ViewOf(const Camera& camera);

// Perspective, with OpenGL's clip space. `aspect` is the picture's width over its height. Nothing nearer to
// the camera's target than 0.45 m is cut off.
glm::mat4 ProjectionOf(const Camera& camera, float aspect);

// One frame's way from the head at rest to the picture and back. Copies what it needs of the scene; pure.
class View {
 public:
  // `pivot_m` is the point about which the head turns (face::Cast::neck_pivot).
  View(const Scene& scene, glm::vec3 pivot_m, float aspect);

  // Where a point of the head at rest is seen: -1 to 1, right and up, with more outside the picture.
  glm::vec2 InPicture(glm::vec3 point_m) const;

  // The way at the depth of `point_m`, along the head's axes at rest, that moves it in the picture by `step`.
  glm::vec3 AtDepthOf(glm::vec3 point_m, glm::vec2 step) const;

  // Whether a surface at this point of the head at rest, with this normal, looks at the camera.
  bool Faces(glm::vec3 point_m, glm::vec3 normal) const;

 private:
  // With the head's turn and shift: from the head at rest to the world.
  glm::vec3 Turned(glm::vec3 point_m) const;

  glm::quat turn_;
  glm::vec3 pivot_m_;
  glm::vec3 shift_m_;
  glm::mat4 view_;
  glm::mat4 projection_;
};

}  // namespace kaori::scene
