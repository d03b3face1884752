// Where the needles stand in the picture that was seen last: to choose one, and to pull it where a hand
// points.
#pragma once

#include <optional>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "render/face/composer.h"
#include "render/face/frame.h"
#include "render/scene/view.h"

namespace kaori::editor {

class Sight {
 public:
  explicit Sight(const face::Cast& cast);

  // The face as it was drawn. `aspect` is the picture's width over its height.
  void Look(const face::Cast& cast, const face::Shape& shape, const scene::Scene& scene, float aspect);

  // The visible needle that is nearest to a place of the picture (0..1 from the left top), if one is near
  // enough to be meant.
  std::optional<std::size_t> Nearest(glm::vec2 place) const;

  // The next visible needle from this one in a direction of the picture, right and up; none when there is
  // none.
  std::optional<std::size_t> Next(std::size_t from, glm::vec2 direction) const;

  // The pull that takes the needle through the picture by `step` (parts of its width and height, right and
  // down), in the plane of the picture.
  glm::vec3 PullAlong(std::size_t needle, glm::vec2 step) const;

  bool seen(std::size_t needle) const { return pins_[needle].seen; }
  glm::vec2 place(std::size_t needle) const;  // In the picture, 0..1 from the left top.

 private:
  struct Pin {
    glm::vec3 root_m{};
    glm::vec2 at{};    // Its root, from the picture's middle in halves of its height; right and up.
    glm::vec2 head{};  // The same of its head.
    bool seen = false;
  };
  glm::mat3 CarrierOf(std::size_t needle) const;

  std::vector<std::vector<face::Frame>> frames_;  // Of each face.
  std::vector<float> gains_;
  std::vector<Pin> pins_;
  face::Terms faces_;  // Of the face that was seen.
  std::optional<scene::View> view_;
  float aspect_ = 1;
};

}  // namespace kaori::editor
