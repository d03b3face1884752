#include "render/passes/dressing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace kaori::passes {
namespace {

// The neck's lower end: the lowest row of the parameter space.
constexpr float kLowestRow = 0.004F;
// The neck is measured this far below the collar's upper end, within half of that; what lies before it is the
// jaw.
constexpr float kBelowCollar_m = 0.020F;
constexpr float kBeforeNeck_m = 0.030F;
// With so much of a face that has no neck, clothes have sunk out of the picture, by kSunk_m. The neck
// withdraws into the head sooner than that (render/face/composer.cpp).
constexpr float kGoneWithNeckless = 0.15F;
constexpr float kSunk_m = 0.32F;
// While the garments that come have less than the one share, and from the other share on, those of one face alone are seen.
// A last piece about the neck would hang before a neckline that opens below it.
constexpr float kComesFrom = 0.3F;
constexpr float kHasComeAt = 0.7F;
// About the neck: so far from its middle a neckline is measured.
constexpr float kNeckline_m = 0.08F;
// A face with less weight than this dresses nobody: one step of 8 bits.
constexpr float kUndressed = 0.004F;

// Over even steps from the middle outwards.
using Heights = std::array<float, Outline::kSamples>;

// Of an edge of cloth, what it adds to the highest points at even steps from the middle; both halves count as one.
void RaiseAlong(const glm::vec3& a, const glm::vec3& b, float half_width_m, Heights& highest) {
  for (const float side : {-1.0F, 1.0F}) {
    const float from = side * a.x, to = side * b.x;
    for (std::size_t i = 0; i < highest.size(); ++i) {
      const float at = half_width_m * static_cast<float>(i) / static_cast<float>(highest.size() - 1);
      if (at < std::min(from, to) || at > std::max(from, to)) continue;
      const float share = from == to ? 0 : (at - from) / (to - from);
      highest[i] = std::max(highest[i], a.y + share * (b.y - a.y));
    }
  }
}

// Steps that no edge crosses are as the one before.
Heights BelowCollar(const Heights& highest, float collar_m) {
  Heights below{};
  float below_m = 0;
  for (std::size_t i = 0; i < highest.size(); ++i) {
    if (std::isfinite(highest[i])) below_m = collar_m - highest[i];
    below[i] = below_m;
  }
  return below;
}

// Where the border lies of garments that have this share, 0..1, to those that are laid outside of them.
float BorderAt(float share) {
  return std::clamp((share - kComesFrom) / (kHasComeAt - kComesFrom), 0.0F, 1.0F);
}

void Add(const Outline& outline, float weight, Outline& to) {
  to.half_width_m += weight * outline.half_width_m;
  for (std::size_t i = 0; i < to.below_collar_m.size(); ++i)
    to.below_collar_m[i] += weight * outline.below_collar_m[i];
}

}  // namespace

float Dressing::reach_m() const {
  if (whole()) return 0;
  float reach = sinks_m;
  for (const WornGarments& w : worn()) {
    const float wider_m = std::abs(outline.half_width_m - w.outline.half_width_m);
    float lifted_m = 0;
    for (std::size_t i = 0; i < w.outline.below_collar_m.size(); ++i)
      lifted_m = std::max(lifted_m, std::abs(outline.below_collar_m[i] - w.outline.below_collar_m[i]));
    reach = std::max(reach, std::abs(w.rise_m) + std::abs(w.widen_m) + wider_m + lifted_m);
  }
  return reach;
}

Necks::Necks(const face::Cast& cast) {
  for (const face::Face& f : cast.faces) {
    Neck neck;
    MeasureEnd(cast.topology, f, neck);
    MeasureCollar(cast, f, neck);
    MeasureOutline(cast, f, neck);
    necks_.push_back(neck);
  }
}

// The neck's end is the lowest row of vertices in the parameter space; its middle is their mean, and its
// radius the farthest of them to a side. Without such vertices it stays at 0.
void Necks::MeasureEnd(const face::Topology& topology, const face::Face& face, Neck& neck) {
  const auto lowest = std::ranges::min_element(topology.uv, {}, [](const glm::vec2& uv) { return uv.y; });
  if (lowest == topology.uv.end()) return;
  std::vector<glm::vec3> row;
  for (std::size_t i = 0; i < topology.uv.size(); ++i) {
    if (topology.uv[i].y < lowest->y + kLowestRow) row.push_back(face.positions[i]);
  }
  for (const glm::vec3& p : row) neck.end_m += p / static_cast<float>(row.size());
  for (const glm::vec3& p : row)
    neck.end_radius_m = std::max(neck.end_radius_m, std::abs(p.x - neck.end_m.x));
}

// The collar is the highest point of all clothes of the face, and far below everything where it wears none.
// The neck's half width is taken a little below the collar, without what lies further forward than the neck,
// such as a chin.
void Necks::MeasureCollar(const face::Cast& cast, const face::Face& face, Neck& neck) {
  neck.collar_m = -1e9F;
  for (const int index : face.props) {
    const face::Prop& prop = cast.props[static_cast<std::size_t>(index)];
    if (prop.part != face::Part::kClothes) continue;
    for (const face::PropVertex& v : prop.vertices) neck.collar_m = std::max(neck.collar_m, v.position.y);
    neck.dressed = neck.dressed || !prop.vertices.empty();
  }
  for (const glm::vec3& p : face.positions) {
    const bool at_collar = std::abs(p.y + kBelowCollar_m - neck.collar_m) < kBelowCollar_m / 2;
    if (at_collar && p.z < kBeforeNeck_m) neck.half_width_m = std::max(neck.half_width_m, std::abs(p.x));
  }
}

// Two garments that share the picture meet at a border that wanders down and outwards. Where their outlines differ, the one
// inside the border ends in the air beyond the other's shoulder: it looks like a wing. So the outline is measured once, as
// heights over even steps from the middle, which mix as numbers do; what mixes is what an audience sees from the front, since
// clothes do not turn with the head.
//
// The highest point of all edges at each step.
//
// The neckline is the same of what lies before the neck, and close to it: a collar's back says nothing of how it opens.
void Necks::MeasureOutline(const face::Cast& cast, const face::Face& face, Neck& neck) {
  Outline& outline = neck.outline;
  std::vector<const face::Prop*> clothes;
  for (const int index : face.props) {
    const face::Prop& prop = cast.props[static_cast<std::size_t>(index)];
    if (prop.part != face::Part::kClothes) continue;
    clothes.push_back(&prop);
    for (const face::PropVertex& v : prop.vertices)
      outline.half_width_m = std::max(outline.half_width_m, std::abs(v.position.x));
  }
  Heights highest, before;
  highest.fill(-std::numeric_limits<float>::infinity());
  before.fill(-std::numeric_limits<float>::infinity());
  for (const face::Prop* prop : clothes) {
    for (const face::Triangle& triangle : prop->triangles)
      for (std::size_t i = 0; i < triangle.size(); ++i) {
        const glm::vec3& a = prop->vertices[triangle[i]].position;
        const glm::vec3& b = prop->vertices[triangle[(i + 1) % triangle.size()]].position;
        RaiseAlong(a, b, outline.half_width_m, highest);
        if (std::min(a.z, b.z) > neck.end_m.z) RaiseAlong(a, b, kNeckline_m, before);
      }
  }
  outline.below_collar_m = BelowCollar(highest, neck.collar_m);
  for (const float below_m : BelowCollar(before, neck.collar_m))
    neck.opens_m += below_m / static_cast<float>(Outline::kSamples);
}

// A face without clothes either has no neck, and then all sink, or it bares its neck from below.
//
// Where one garment is open and the other is closed about the neck, the closed one's last piece would hang before the
// opening: so what opens most is laid first, from the collar on.
Dressing Necks::Dress(const face::Terms& faces) const {
  Dressing d;
  const face::Terms sorted = InOrder(faces, [this](std::uint16_t face) { return -necks_[face].opens_m; });
  float dressed = 0;
  float half_width_m = 0;
  float radius_m = 0;
  Outline outline;
  for (const face::Term& t : sorted) {
    const Neck& neck = necks_[t.index];
    if (!neck.dressed || t.weight < kUndressed) continue;
    dressed += t.weight;
    d.collar_m += t.weight * neck.collar_m;
    half_width_m += t.weight * neck.half_width_m;
    radius_m += t.weight * neck.end_radius_m;
    Add(neck.outline, t.weight, outline);
    d.neck_m += t.weight * glm::vec2(neck.end_m.x, neck.end_m.z);
  }
  if (dressed <= 0) return d;
  d.collar_m /= dressed;
  half_width_m /= dressed;
  Add(outline, 1 / dressed, d.outline);
  d.neck_m /= dressed;
  radius_m = std::max(radius_m / dressed, 1e-4F);
  float bare = 0;
  float neckless = 0;
  for (const face::Term& t : sorted) {
    const Neck& neck = necks_[t.index];
    if (neck.dressed) continue;
    const float has_neck = std::min(neck.end_radius_m / radius_m, 1.0F);
    bare += t.weight * has_neck;
    neckless += t.weight * (1 - has_neck);
  }
  const float sunk = std::min(neckless / ((dressed + bare + neckless) * kGoneWithNeckless), 1.0F);
  if (sunk >= 1) return d;
  d.sinks_m = neckless < kUndressed ? 0 : kSunk_m * sunk * std::sqrt(sunk);
  float laid = 0;
  const float covered = dressed / (dressed + bare);
  for (const face::Term& t : sorted) {
    const Neck& neck = necks_[t.index];
    if (!neck.dressed || t.weight < kUndressed) continue;
    const float from = covered * BorderAt(laid / dressed);
    laid += t.weight;
    d.garments[d.count++] = {t.index,
                             from,
                             covered * BorderAt(laid / dressed),
                             d.collar_m - neck.collar_m,
                             half_width_m - neck.half_width_m,
                             t.weight / dressed,
                             neck.outline};
  }
  // The outermost that is seen leaves no gap at the lower edge.
  const auto worn = std::span(d.garments).first(d.count);
  const auto outermost =
      std::find_if(worn.rbegin(), worn.rend(), [](const auto& w) { return w.from < w.to; });
  if (outermost != worn.rend() && bare < kUndressed) outermost->to = 2;
  return d;
}

}  // namespace kaori::passes
