// How garments are worn while faces cross-fade: which part of the picture shows whose, and how each is fitted
// to the neck that the faces have together.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "render/face/cast.h"
#include "render/face/weights.h"

namespace kaori::passes {

// The terms by what `rank` gives of each face, the least first, and of equals in the order of the cast, whatever the order of the
// fade; what weighs less than nothing weighs nothing. Pure, as `rank` is; allocates nothing.
template <class Rank>
face::Terms InOrder(const face::Terms& faces, const Rank& rank) {
  struct Ranked {
    float rank = 0;
    face::Term term;
  };
  std::array<Ranked, face::Terms::kCapacity> ranked{};
  const auto end = std::ranges::transform(faces, ranked.begin(), [&](const face::Term& term) {
                     return Ranked{rank(term.index), term};
                   }).out;
  std::sort(ranked.begin(), end, [](const Ranked& a, const Ranked& b) {
    return std::pair(a.rank, a.term.index) < std::pair(b.rank, b.term.index);
  });
  face::Terms ordered;
  for (auto each = ranked.begin(); each != end; ++each)
    ordered.Push(each->term.index, std::max(each->term.weight, 0.0F));
  return ordered;
}

// The upper edge of clothes as an audience sees it before the backdrop; both halves are alike. Lengths in metres.
struct Outline {
  static constexpr std::size_t kSamples = 16;
  float half_width_m = 0;
  // How far it lies below the collar, in even steps from the middle to its end.
  std::array<float, kSamples> below_collar_m{};
};

// One face's garments in a frame. Lengths in metres.
struct WornGarments {
  std::uint16_t face = 0;
  // Of the order in which garments replace each other, 0 at the collar .. 1 at the lower edge of the picture:
  // they are seen where the order lies within [from, to), and no other garment is; empty where they lend their colour
  // alone.
  float from = 0;
  float to = 1;
  // So much higher than they were sewn, and so much wider about the neck.
  float rise_m = 0;
  float widen_m = 0;
  // Its face's share of those that wear clothes, 0..1: garments that replace each other are of one colour
  // meanwhile.
  float weight = 1;
  // As they were sewn.
  Outline outline{};
};

// All garments of a frame, those that open most about the neck first, whatever the order of the fade: a call back to the
// face before turns nothing round.
struct Dressing {
  std::array<WornGarments, face::Terms::kCapacity> garments{};
  std::size_t count = 0;
  // Where the collars sit. Y.
  float collar_m = 0;
  // The one that all garments have meanwhile: beyond another's shoulders nothing of them shows.
  Outline outline{};
  // The neck's axis at its lower end: x, z.
  glm::vec2 neck_m{};
  // As the neck withdraws into a face that has none, clothes sink out of the picture: by so much, 0 or more.
  float sinks_m = 0;

  std::span<const WornGarments> worn() const { return {garments.data(), count}; }
  // One face's garments, as they were sewn.
  bool whole() const { return count == 1 && garments[0].from <= 0 && garments[0].to >= 1 && sinks_m <= 0; }
  // How far a garment may lie beyond its place at rest.
  float reach_m() const;
};

// The necks and collars of a cast, measured once. Borrows nothing.
class Necks {
 public:
  explicit Necks(const face::Cast& cast);

  // `faces` as composed, sum 1. Pure; allocates nothing.
  Dressing Dress(const face::Terms& faces) const;

 private:
  struct Neck {
    // A face without clothes has no collar.
    bool dressed = false;
    // Y of the clothes' upper end, and the neck's half width a little below it.
    float collar_m = 0;
    float half_width_m = 0;
    // The neck's lower end: its middle, and how far it reaches from there; 0 where the face has no neck.
    glm::vec3 end_m{};
    float end_radius_m = 0;
    Outline outline{};
    // How far below the collar clothes begin before the neck, the mean about it.
    float opens_m = 0;
  };
  static void MeasureEnd(const face::Topology& topology, const face::Face& face, Neck& neck);
  static void MeasureCollar(const face::Cast& cast, const face::Face& face, Neck& neck);
  static void MeasureOutline(const face::Cast& cast, const face::Face& face, Neck& neck);

  std::vector<Neck> necks_;
};

}  // namespace kaori::passes
