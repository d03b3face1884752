// Which faces, expressions and channels have weight in a frame. Only these cost anything.
//
// A fade moves weights. A new call while an earlier fade still runs only adds a term, so the shape never
// leaps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec2.hpp>

namespace kaori::face {

// One thing that has weight: the index of a face in Cast::faces, or of an expression in Cast::expressions.
struct Term {
  std::uint16_t index = 0;
  float weight = 0;
  friend bool operator==(const Term&, const Term&) = default;
};

// A short list without allocation. Beyond the capacity the lightest term, by magnitude, is dropped.
class Terms {
 public:
  // More faces or expressions than a show fades at once; past it the shape loses what is least seen.
  static constexpr int kCapacity = 32;

  const Term* begin() const { return terms_.data(); }
  const Term* end() const { return terms_.data() + size_; }
  int size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Term& operator[](int i) const { return terms_[static_cast<std::size_t>(i)]; }
  void clear() { size_ = 0; }
  // Appends a term, even if one of this index is there.
  void Push(std::uint16_t index, float weight);
  // Adds to the term of this index where there is one, else appends.
  void Add(std::uint16_t index, float weight);
  // Of the weights, signs counted.
  float sum() const;
  // Equal terms in the same order.
  friend bool operator==(const Terms& a, const Terms& b);

 private:
  std::array<Term, kCapacity> terms_{};
  int size_ = 0;
};

// How what hangs at one side of the head swings, as a chain of two joints: sideways (+X) and forwards (+Z).
struct Hanging {
  glm::vec2 upper_rad{};
  glm::vec2 lower_rad{};
};

// P = sum_i s_i ( B_i + sum_j t_j E_ij + sum_k c_k A_ik )
//
// With two faces and two expressions and no channel this is equation 1 of Arai et al. 1994:
//   P = s1 (t1 P11 + t2 P12) + s2 (t1 P21 + t2 P22),   s1 + s2 = t1 + t2 = 1,   P_ij = B_i + E_ij.
// B_i is face i, E_ij what expression j does to it, A_ik what channel k (brows, lids, jaw, mouth) does on
// top.
struct Weights {
  // s_i, sum 1.
  Terms faces;
  // t_j, sum 1; indices of Cast::expressions.
  Terms expressions;
  // c_k, free; indices of Cast::expressions.
  Terms channels;
  // 0: the expression's own mouth; 1: it gives way to the channels, by Topology::mouth_share.
  float mouth_given_away = 0;
  // 0 open .. 1 shut: the character's left, right.
  std::array<float, 2> lids_shut{};
  // The character's left, right; on faces of which something hangs (Face::hang_arms_m).
  std::array<Hanging, 2> hanging{};
};

// What can be played of `weights` by a cast of so many faces and expressions: terms that are not finite, or
// name nothing, are left out; the others are kept within kHeaviest, the faces are brought to the sum 1 (face
// 0 alone if they come near to cancelling out), what is a part of something is kept within 0..1, and what hangs within kFarthestHanging_rad.
Weights Playable(const Weights& weights, std::size_t faces, std::size_t expressions);
// Beyond this, by magnitude, no weight is played: the face would leave the picture.
inline constexpr float kHeaviest = 4;
// Beyond this an arm of its length is no swing any more.
inline constexpr float kFarthestHanging_rad = 1;

}  // namespace kaori::face
