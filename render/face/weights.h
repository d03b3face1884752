// Which faces, expressions and channels have weight in a frame. Only these cost anything.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kaori::face {

struct Term {
  std::uint16_t index = 0;
  float weight = 0;
  friend bool operator==(const Term&, const Term&) = default;
};

// A short list without allocation. Beyond the capacity the lightest term is dropped.
class Terms {
 public:
  static constexpr int kCapacity = 32;

  const Term* begin() const { return terms_.data(); }
  const Term* end() const { return terms_.data() + size_; }
  int size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Term& operator[](int i) const { return terms_[static_cast<std::size_t>(i)]; }
  void clear() { size_ = 0; }
  void Push(std::uint16_t index, float weight);
  void Add(std::uint16_t index, float weight);  // To the term of this index, if there is one already.
  float sum() const;
  friend bool operator==(const Terms& a, const Terms& b);

 private:
  std::array<Term, kCapacity> terms_{};
  int size_ = 0;
};

// P = sum_i s_i ( B_i + sum_j t_j E_ij + sum_k c_k A_ik )  (equation 1 of Arai et al. 1994, and channels).
struct Weights {
  Terms faces;                       // s_i, sum 1.
  Terms expressions;                 // t_j, sum 1; indices of Cast::expressions.
  Terms channels;                    // c_k, free; indices of Cast::expressions.
  float mouth_given_away = 0;        // 0: the expression's own mouth; 1: it gives way to the channels.
  std::array<float, 2> lids_shut{};  // 0 open .. 1 shut: the character's left, right.
};

// What can be played of `weights` by a cast of so many faces and expressions: terms that are not finite, or
// name nothing, are left out; the others are kept within kHeaviest, the faces are brought to the sum 1 (face
// 0 alone if they come near to cancelling out), and what is a part of something is kept within 0..1.
Weights Playable(const Weights& weights, std::size_t faces, std::size_t expressions);
inline constexpr float kHeaviest = 4;

}  // namespace kaori::face
