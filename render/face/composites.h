// All composites of a cast, built once: what each expression does to each face, ready to be added up.
//
// The paper adds up whole composites P_ij (section 2: they must be composed for each face first, since the
// sum of deformations is another shape). Here P_ij = B_i + E_ij is kept in two parts, which gives the same
// sum, as the weights of the expressions sum to 1, with fewer floats to read: E_ij covers the moving vertices
// alone.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/face/aligned.h"
#include "render/face/cast.h"
#include "render/face/frame.h"

namespace kaori::face {

// Borrows nothing after construction. Every array it gives out is aligned and padded for Blend; three packed
// floats a vertex. Refresh and Outdate belong to one thread; arrays hold until the next of either.
class Composites {
 public:
  // FindFaults (check.h) finds nothing in the cast.
  explicit Composites(const Cast& cast);

  // Counts of the cast that it was built of.
  std::size_t faces() const { return faces_; }
  std::size_t expressions() const { return expressions_; }

  // Floats of a whole face, and of the part that moves with expressions; both padded to cache lines.
  std::size_t face_floats() const { return face_floats_; }
  std::size_t moving_floats() const { return moving_floats_; }

  // B_i: face_floats() long.
  const float* base(std::size_t face) const { return bases_.data() + face * face_floats_; }
  // E_ij, metres: moving_floats() long; null where the expression moves nothing.
  const float* displacement(std::size_t face, std::size_t expression) const {
    const AlignedFloats& faces = displacements_[expression];
    return faces.size() > 0 ? faces.data() + face * moving_floats_ : nullptr;
  }

  // The cast's expression has changed: what it does to each face is out of date until Refresh.
  // Allocates when it moves something for the first time.
  void Outdate(const Cast& cast, std::size_t expression);
  // Brings what the expression does to the face up to date; at once done where it is. Allocates nothing.
  void Refresh(const Cast& cast, std::size_t face, std::size_t expression);
  // How far expression j takes the lower lip's middle down on face i.
  float jaw_drop_m(std::size_t face, std::size_t expression) const {
    return jaw_drops_m_[face * expressions_ + expression];
  }

  // The part of the jaw drop that gives way with the mouth, 0..1.
  float jaw_mouth_share() const { return jaw_mouth_share_; }
  // What all arrays take in memory.
  std::size_t bytes() const;

 private:
  // The steps of construction, in this order.
  void CopyBases(const Cast& cast);
  void FindJaw(const Cast& cast);
  void FitFaces(const Cast& cast);
  void ComposeFace(const Cast& cast, std::size_t face, std::size_t expression);

  // How expressions are carried to a face: see frame.h.
  struct Carrier {
    std::vector<Frame> frames;
    std::vector<glm::mat3> turns;
  };

  std::size_t faces_ = 0;
  std::size_t expressions_ = 0;
  std::size_t face_floats_ = 0;
  std::size_t moving_floats_ = 0;
  AlignedFloats bases_;
  // Per expression, of all faces; empty where it moves nothing.
  std::vector<AlignedFloats> displacements_;
  // Per face.
  std::vector<Carrier> carriers_;
  // Per face and expression.
  std::vector<std::uint8_t> outdated_;
  // The control points of one face with one expression.
  AlignedFloats moved_;
  std::vector<float> jaw_drops_m_;
  // Of "LC" in the net.
  std::optional<std::size_t> jaw_point_;
  float jaw_mouth_share_ = 0;
};

}  // namespace kaori::face
