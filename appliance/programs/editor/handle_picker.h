// Where the handles stand in the picture that was shown last: to choose one, and to pull it where a pointer
// goes. A handle is a control point as it stands on the face that was drawn: a root on the skin and a head
// above it along the normal.
#pragma once

#include <optional>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "render/face/composer.h"
#include "render/face/frame.h"
#include "render/scene/view.h"

namespace kaori::editor {

// One thread. Positions are of the picture, 0..1 from the left top, unless something else is said. Before the
// first Look no handle is seen.
class HandlePicker {
 public:
  // Fits a frame to each handle on each face: takes some milliseconds. The cast is not kept.
  explicit HandlePicker(const face::Cast& cast);

  // The face as it was drawn. `aspect` is the picture's width over its height. To be called after each frame;
  // it allocates nothing.
  void Look(const face::Cast& cast, const face::Shape& shape, const scene::Scene& scene, float aspect);

  // The visible handle that is nearest to a position of the picture (0..1 from the left top), if one is near
  // enough to be meant.
  std::optional<std::size_t> Nearest(glm::vec2 position) const;

  // The next visible handle from this one in a direction of the picture, right and up; none when there is
  // none.
  std::optional<std::size_t> Next(std::size_t from, glm::vec2 direction) const;

  // The pull that takes the handle through the picture by `step` (parts of its width and height, right and
  // down), in the plane of the picture.
  glm::vec3 PullAlong(std::size_t handle, glm::vec2 step) const;

  // Whether the handle stands on the side of the face that is turned to the camera. `handle` is below the
  // number of control points, here and above.
  bool seen(std::size_t handle) const { return handles_[handle].seen; }
  glm::vec2 position(std::size_t handle) const;  // In the picture, 0..1 from the left top.

 private:
  struct Handle {
    // Where it stands on the skin, in the cast's frame.
    glm::vec3 root_m{};
    glm::vec2 at{};    // Its root, from the picture's middle in halves of its height; right and up.
    glm::vec2 head{};  // The same of its head.
    bool seen = false;
  };
  // The matrix that takes a pull (u, v, outwards) to metres in the cast's frame, on the faces that were
  // shown.
  glm::mat3 CarrierOf(std::size_t handle) const;

  std::vector<std::vector<face::Frame>> frames_;  // Of each face.
  // By how much each face exaggerates expressions (face::Face::expression_gain).
  std::vector<float> gains_;
  std::vector<Handle> handles_;
  face::Terms faces_;  // Of the face that was seen.
  // The camera of the last picture, and its width over its height; no view before the first Look.
  std::optional<scene::View> view_;
  float aspect_ = 1;
};

}  // namespace kaori::editor
