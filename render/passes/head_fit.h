// Carries what was made for one face's head, hair and glasses, to the head that faces have together while
// they cross-fade: a smooth motion of the space about the head.
#pragma once

#include <array>
#include <vector>

#include <glm/vec4.hpp>

#include "render/face/cast.h"
#include "render/face/weights.h"

namespace kaori::passes {

class HeadFit {
 public:
  // Motions are polynomials of the third degree in decimetres from kMiddle_m, in the order that hair.vert
  // reads: 1, x, y, z, xx, yy, zz, xy, yz, zx, xxx, xxy, xxz, yyx, yyy, yyz, zzx, zzy, zzz, xyz. Each
  // coefficient is a motion in metres; w is not used.
  static constexpr std::size_t kTerms = 20;
  static constexpr glm::vec3 kMiddle_m{0, 0.03F, -0.01F};
  using Motion = std::array<glm::vec4, kTerms>;

  // Fits a motion for every two faces, by least squares over the scalp: some milliseconds. Borrows nothing.
  explicit HeadFit(const face::Cast& cast);

  // From the head of `face` to that of `faces` together. Pure; allocates nothing.
  Motion To(const face::Terms& faces, std::size_t face) const;

  // How far it moves anything that is worn on a head, metres.
  static float Reach_m(const Motion& motion);

 private:
  std::size_t faces_ = 0;
  // From each face to each other: [from * faces_ + to].
  std::vector<Motion> motions_;
};

}  // namespace kaori::passes
