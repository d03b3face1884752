#include "render/passes/prop_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "render/passes/lock_order.h"

namespace kaori::passes {
namespace {

// Hair has a tangent, its position in the lock and the lock's number; all else has its shade alone.
gl::Mesh MeshOf(const face::Prop& prop, const gl::Buffer& vertices, const gl::Buffer& numbers,
                std::span<const face::Triangle> triangles) {
  using face::PropVertex;
  using gl::Scalar;
  std::vector<std::uint32_t> indices;
  for (const face::Triangle& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
  constexpr int kStride = sizeof(PropVertex);
  constexpr gl::Attribute kPosition{0, 3, Scalar::kFloat, offsetof(PropVertex, position)};
  constexpr gl::Attribute kNormal{1, 3, Scalar::kFloat, offsetof(PropVertex, normal)};
  if (prop.part != face::Part::kHair) {
    constexpr gl::Attribute kShade{2, 1, Scalar::kFloat, offsetof(PropVertex, shade)};
    return gl::Mesh({{vertices, kStride, {kPosition, kNormal, kShade}}}, indices);
  }
  constexpr gl::Attribute kTangent{2, 3, Scalar::kFloat, offsetof(PropVertex, tangent)};
  constexpr gl::Attribute kLock{3, 3, Scalar::kFloat, offsetof(PropVertex, along)};
  return gl::Mesh({{vertices, kStride, {kPosition, kNormal, kTangent, kLock}},
                   {numbers, sizeof(float), {{4, 1, Scalar::kFloat, 0}}}},
                  indices);
}

// Hard things say `across` far below 0, as hair.frag.
constexpr float kHardAcross = -50;

constexpr auto kSides = Slice::kSides;

// Where each side looks. Asked of for every corner of every lock, so worked out once.
const std::array<glm::vec2, kSides>& SideDirections() {
  static const auto directions = [] {
    std::array<glm::vec2, kSides> made;
    for (std::size_t side = 0; side < kSides; ++side) {
      const float round = 2 * std::numbers::pi_v<float> * static_cast<float>(side) / kSides;
      made[side] = {std::cos(round), std::sin(round)};
    }
    return made;
  }();
  return directions;
}

// Grows a prism about points.
struct Prism {
  Slice slice;
  std::array<float, kSides> reach_m;

  Prism() { reach_m.fill(-1e9F); }

  void Add(const glm::vec3& p) {
    slice.low_m = std::min(slice.low_m, p.y);
    slice.high_m = std::max(slice.high_m, p.y);
    // How far the points reach along each side's direction: a support function.
    const auto& directions = SideDirections();
    for (std::size_t side = 0; side < kSides; ++side) {
      reach_m[side] = std::max(reach_m[side], glm::dot(directions[side], glm::vec2(p.x, p.z)));
    }
  }

  // Corners where neighbouring sides meet: nothing lies outside.
  Slice Finish() const {
    constexpr float kTurn = 2 * std::numbers::pi_v<float> / kSides;
    Slice s = slice;
    for (std::size_t side = 0; side < kSides; ++side) {
      const glm::vec2 out = SideDirections()[side];
      // Two neighbouring sides, at distances r0 and r1 from the axis and a turn apart, meet at r0 along the
      // one and (r1 - r0 cos) / sin across it.
      const float along = (reach_m[(side + 1) % kSides] - reach_m[side] * std::cos(kTurn)) / std::sin(kTurn);
      s.outline[side] = out * reach_m[side] + glm::vec2(-out.y, out.x) * along;
    }
    return s;
  }
};

// Slices of equal height. A triangle belongs to each slice that it passes through, so no slice is too small;
// one that it passes through between two of its corners gets all three.
std::array<Slice, kPropSlices> SlicesOf(const face::Prop& prop) {
  const auto [low, high] =
      std::ranges::minmax_element(prop.vertices, {}, [](const face::PropVertex& v) { return v.position.y; });
  if (low == prop.vertices.end()) return {};
  const float low_m = low->position.y;
  const float per_metre = kPropSlices / std::max(high->position.y - low_m, 1e-6F);
  const auto slice_of = [&](face::Index v) {
    const float slice = (prop.vertices[v].position.y - low_m) * per_metre;
    return std::clamp(static_cast<int>(slice), 0, kPropSlices - 1);
  };
  std::array<Prism, kPropSlices> prisms;
  for (const face::Triangle& t : prop.triangles) {
    const auto [first, last] = std::minmax({slice_of(t[0]), slice_of(t[1]), slice_of(t[2])});
    for (int s = first; s <= last; ++s) {
      for (const face::Index v : t) prisms[static_cast<std::size_t>(s)].Add(prop.vertices[v].position);
    }
  }
  std::array<Slice, kPropSlices> slices;
  std::ranges::transform(prisms, slices.begin(), &Prism::Finish);
  return slices;
}

// Glasses and pins are hair by their part, and say by their first vertex that they are not.
bool IsHard(const face::Prop& prop) {
  return prop.part == face::Part::kHair && !prop.vertices.empty() && prop.vertices[0].across < kHardAcross;
}

// Hair is sorted, all else is drawn in the order of its file.
PropForm FormOf(const face::Prop& prop) {
  PropForm form{.slices = SlicesOf(prop),
                .numbers = {},
                .triangles = prop.triangles,
                .behind_from = prop.triangles.size()};
  if (prop.part != face::Part::kHair) return form;
  form.numbers = LockNumbers(prop);
  LockOrder order = OuterLocksFirst(prop, form.numbers);
  form.triangles = std::move(order.triangles);
  if (!IsHard(prop)) form.behind_from = order.behind_from;
  return form;
}

}  // namespace

std::vector<PropForm> FormsOf(std::span<const face::Prop> props) {
  std::vector<PropForm> forms(props.size());
  std::ranges::transform(props, forms.begin(), FormOf);
  return forms;
}

PropMesh::PropMesh(const face::Prop& prop, const PropForm& form)
    : part(prop.part),
      hard(IsHard(prop)),
      paint(prop.colour),
      slices(form.slices),
      vertices(gl::Buffer::Of(std::span<const face::PropVertex>(prop.vertices))),
      numbers(gl::Buffer::Of(std::span<const float>(form.numbers))),
      mesh(MeshOf(prop, vertices, numbers, std::span(form.triangles).first(form.behind_from))),
      behind(MeshOf(prop, vertices, numbers, std::span(form.triangles).subspan(form.behind_from))) {}

Appearance::Appearance(const face::Cast& cast, std::span<const PropForm> forms)
    : presence_(cast.props.size()) {
  meshes_.reserve(cast.props.size());
  for (std::size_t i = 0; i < cast.props.size(); ++i) meshes_.emplace_back(cast.props[i], forms[i]);
  for (const face::Face& f : cast.faces) worn_.push_back(f.props);
}

// A face that wears a prop twice would count twice, which the clamp bounds.
void Appearance::Weigh(const face::Terms& faces) {
  std::ranges::fill(presence_, 0.0F);
  for (const face::Term& term : faces) {
    for (const int prop : worn_[term.index]) presence_[static_cast<std::size_t>(prop)] += term.weight;
  }
  for (float& p : presence_) p = std::clamp(p, 0.0F, 1.0F);
}

}  // namespace kaori::passes
