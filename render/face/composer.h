// Composes the face of one frame: weights in; surface, normals, eyes and mouth out.
//
// The method is that of Arai et al. 1994, section 3, with channels on top (the formula stands at Weights).
// What the paper does not have: lids that ride on the eyeball (eyelids.h), a fine mesh for display
// (FineMesh), and a mouth that yields.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include <glm/vec3.hpp>

#include "render/face/cast.h"
#include "render/face/weights.h"

namespace kaori::face {

// The cage alone, for wireframe and flat shading, or the fine mesh as well.
enum class Detail : std::uint8_t { kCage, kFine };

// One composed face, in metres in the head's frame at rest (cast.h): the turn of the head comes later, in
// shaders. All spans lie in the composer and hold until its next Compose; the three arrays of the fine mesh
// are empty at Detail::kCage. Each array has one float of slack behind it, so that a reader may load four
// floats at the last vertex.
struct Shape {
  // Topology::vertex_count of each; normals are unit vectors.
  std::span<const glm::vec3> cage;
  std::span<const glm::vec3> cage_normals;
  // For each cage vertex: 0 shut in, 1 open.
  std::span<const float> occlusion;
  // One for each row of FineMesh::from_cage.
  std::span<const glm::vec3> fine;
  std::span<const glm::vec3> fine_normals;
  std::span<const float> fine_occlusion;
  // [0] the character's left (+X).
  std::array<EyeBall, 2> eyes{};
  // By the operator and the expressions together, 0..1.
  std::array<float, 2> lids_shut{};
  EyeLook eye_look;
  EyeSurface eye_surface;
  // 0..1: how red the skin is.
  float flush = 0;
  MouthFit mouth;
  // How far the lower lip's middle (point "LC") went down; never negative.
  float jaw_drop_m = 0;
  // The faces as blended: cleaned, sum 1. For cross-fading their textures.
  Terms faces;
};

// Borrows the cast, which must outlive it and not change but as Renew says. All composites are built in the
// constructor (about 20 kB and 50 us each: 10 faces with 20 expressions take 10 ms). FindFaults (check.h)
// finds nothing in the cast: then nothing here can fail, and there are no errors to return.
class Composer {
 public:
  // Builds all composites, and allocates all that it needs but what Renew says.
  explicit Composer(const Cast& cast);
  ~Composer();
  Composer(Composer&&) noexcept;

  // Does not block, allocates nothing, locks nothing; one thread at a time. The cost grows with the terms
  // that have weight, never with the number of faces and expressions that are loaded. Weights that are not
  // finite, or name a face or expression that does not exist, count as zero; face weights are brought to the
  // sum 1; with no face left, the reference face is shown.
  const Shape& Compose(const Weights& weights, Detail detail);

  // The displacement, the lids or the residual of the cast's expression of this index are not what they were.
  // FindFaults finds nothing in it, as before. What it does to a face is worked out when it is next composed
  // with weight, some 30 us for each face. Allocates when the expression moves something for the first time.
  void Renew(std::size_t expression);

  // What Compose gave last; empty before the first.
  const Shape& shape() const { return shape_; }

 private:
  // Arrays and streams of the sum, on the heap so that a composer can move.
  struct Work;
  const Cast& cast_;
  std::unique_ptr<Work> work_;
  Shape shape_;
};

}  // namespace kaori::face
