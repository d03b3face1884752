// Composes the face of one frame: weights in; surface, normals, eyes and mouth out.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include <glm/vec3.hpp>

#include "render/face/cast.h"
#include "render/face/weights.h"

namespace kaori::face {

enum class Detail : std::uint8_t { kCage, kFine };

// One composed face. All spans lie in the composer and hold until its next Compose; the three arrays of the
// fine mesh are empty at Detail::kCage. Each array has one float of slack behind it, so that a reader may
// load four floats at the last vertex.
struct Shape {
  std::span<const glm::vec3> cage;
  std::span<const glm::vec3> cage_normals;
  std::span<const float> occlusion;  // Per cage vertex: 0 shut in, 1 open.
  std::span<const glm::vec3> fine;
  std::span<const glm::vec3> fine_normals;
  std::span<const float> fine_occlusion;
  std::array<EyeBall, 2> eyes{};     // [0] the character's left (+X).
  std::array<float, 2> lids_shut{};  // By the operator and the expressions together, 0..1.
  EyeLook eye_look;
  MouthFit mouth;
  float jaw_drop_m = 0;  // How far the lower lip's middle (point "LC") went down; never negative.
  Terms faces;           // The faces as blended: cleaned, sum 1. For cross-fading their textures.
};

// Borrows the cast, which must outlive it and not change but as Renew says. All composites are built in the
// constructor (about 20 kB and 50 us each). The cast must have passed CheckCast.
class Composer {
 public:
  explicit Composer(const Cast& cast);
  ~Composer();
  Composer(Composer&&) noexcept;

  // Allocates nothing, locks nothing; one thread at a time. Weights that are not finite, or name a face or
  // expression that does not exist, count as zero; face weights are brought to the sum 1; with no face left,
  // the reference face is shown.
  const Shape& Compose(const Weights& weights, Detail detail);

  // The displacement, the lids or the residual of the cast's expression of this index are not what they were.
  // It must pass CheckCast as before. What it does to a face is worked out when it is next composed with
  // weight, some 30 us for each face. Allocates when the expression moves something for the first time.
  void Renew(std::size_t expression);

  // What Compose gave last.
  const Shape& shape() const { return shape_; }

 private:
  struct Work;
  const Cast& cast_;
  std::unique_ptr<Work> work_;
  Shape shape_;
};

}  // namespace kaori::face
