#include "render/passes/handles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"

namespace kaori::passes {
namespace {

// From the skin to the middle of the head, as nothing pulls it.
constexpr float kLength_m = 0.0095F;
// So far the tip sticks in the skin.
constexpr float kDeepest_m = 0.0016F;
// The head's radius.
constexpr float kHead_m = 0.00115F;

// A pulled handle is longer by so much of its pull, up to this pull.
constexpr float kPullShown = 0.6F;
constexpr float kFarthestPull_m = 0.020F;
// Wholly warm from here on.
constexpr float kWarmPull_m = 0.008F;

// How a handle is drawn: larger than the others, and in which colour.
struct Role {
  float size = 1;
  glm::vec3 paint{};
  float painted = 1;  // The rest is plain.
};
constexpr float kPlainSize = 1;
constexpr Role kChosen{1.9F, {1.000F, 0.170F, 0.020F}};
constexpr Role kPartner{1.4F, {1.000F, 0.500F, 0.250F}};
constexpr glm::vec3 kPulledPaint{0.900F, 0.330F, 0.030F};

// Heads that nothing pulls: cool on warm skin, pale on a dark stage.
constexpr glm::vec3 kOnSkin{0.030F, 0.150F, 0.300F};
constexpr glm::vec3 kOnWires{0.700F, 0.620F, 0.520F};

// What stays of a handle that is hidden.
constexpr float kGlimmer = 0.4F;

// root, axis and paint of HandlesPass::Texels.
constexpr int kTexelsEach = 3;

// The head is a ball of rings, the shaft a cone without a floor. Seen along +Z from the tip.
constexpr int kHandleSpokes = 10;
constexpr int kHandleRings = 6;
constexpr int kShaftSides = 5;

struct Corner {
  glm::vec3 out;    // Unit: where the surface looks.
  glm::vec2 along;  // x: 0 the tip .. 1 the head's middle; y: 1 on the head.
};

glm::vec2 Round(int step, int steps) {
  const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(step) / static_cast<float>(steps);
  return {std::cos(angle), std::sin(angle)};
}

// Rings of the head from the far pole on, then the shaft's upper and lower end.
std::vector<Corner> HandleCorners() {
  std::vector<Corner> corners;
  for (int ring = 0; ring <= kHandleRings; ++ring) {
    const float polar = std::numbers::pi_v<float> * static_cast<float>(ring) / kHandleRings;
    for (int spoke = 0; spoke < kHandleSpokes; ++spoke) {
      const glm::vec2 way = Round(spoke, kHandleSpokes) * std::sin(polar);
      corners.push_back({{way, std::cos(polar)}, {1, 1}});
    }
  }
  for (const float along : {1.0F, 0.0F}) {
    for (int side = 0; side < kShaftSides; ++side)
      corners.push_back({{Round(side, kShaftSides), 0}, {along, 0}});
  }
  return corners;
}

// Two rows of `columns` corners each, joined all round; the first row is the upper one.
void AppendBelt(std::uint32_t first, std::uint32_t columns, std::vector<std::uint32_t>& indices) {
  for (std::uint32_t c = 0; c < columns; ++c) {
    const std::uint32_t a = first + c;
    const std::uint32_t b = first + (c + 1) % columns;
    indices.insert(indices.end(), {a, a + columns, b + columns, a, b + columns, b});
  }
}

std::vector<std::uint32_t> HandleIndices() {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t ring = 0; ring < kHandleRings; ++ring)
    AppendBelt(ring * kHandleSpokes, kHandleSpokes, indices);
  AppendBelt((kHandleRings + 1) * kHandleSpokes, kShaftSides, indices);
  return indices;
}

glm::vec3 Mean(const face::SparseRows& rows, std::size_t row, std::span<const glm::vec3> of) {
  glm::vec3 sum{0};
  for (std::uint32_t k = rows.row_start[row]; k < rows.row_start[row + 1]; ++k)
    sum += rows.weight[k] * of[rows.column[k]];
  return sum;
}

// Lids and lips turn their margins inwards: handles stand as the face does about them, within so far.
constexpr float kBeside_m = 0.011F;

// For each control point those within three times kBeside_m on the reference face, with a Gaussian's weights.
face::SparseRows BesideEachOther(const face::Cast& cast) {
  const std::size_t count = cast.net.points.size();
  std::vector<glm::vec3> positions(count);
  for (std::size_t i = 0; i < count; ++i)
    positions[i] = Mean(cast.net.surface, i, cast.faces.front().positions);
  face::SparseRows rows{{0}, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const float away = glm::distance(positions[i], positions[j]) / kBeside_m;
      if (away > 3) continue;
      rows.column.push_back(static_cast<face::Index>(j));
      rows.weight.push_back(std::exp(-0.5F * away * away));
    }
    rows.row_start.push_back(static_cast<std::uint32_t>(rows.column.size()));
  }
  return rows;
}

// Metres; 0 where the point has none.
float PullOf(const scene::Handles& handles, std::size_t point) {
  if (point >= handles.pulls_m.size() || !std::isfinite(handles.pulls_m[point])) return 0;
  return std::clamp(handles.pulls_m[point], 0.0F, kFarthestPull_m);
}

// Pulled handles are warm by the square root of their pull, so that small ones show.
Role RoleOf(const scene::Handles& handles, std::size_t point) {
  if (static_cast<int>(point) == handles.chosen) return kChosen;
  if (static_cast<int>(point) == handles.partner) return kPartner;
  const float warm = std::min(PullOf(handles, point) / kWarmPull_m, 1.0F);
  return {kPlainSize, kPulledPaint, std::sqrt(warm)};
}

// Eased at both ends, so that handles come out of the skin softly.
float Grown(float shown) {
  const float t = std::isfinite(shown) ? std::clamp(shown, 0.0F, 1.0F) : 0.0F;
  return t * t * (3 - 2 * t);
}

}  // namespace

HandlesPass::HandlesPass(gl::Program program, const face::Cast& cast)
    : net_(&cast.net),
      beside_(BesideEachOther(cast)),
      normals_(net_->points.size()),
      axes_(net_->points.size()),
      program_(std::move(program)),
      first_(program_.Find("first")),
      opacity_(program_.Find("opacity")),
      plain_(program_.Find("plain")),
      handles_(net_->points.size()),
      texture_({.width_px = kTexelsEach,
                .height_px = std::max(static_cast<int>(net_->points.size()), 1),
                .texels = gl::Texels::kFloat4}),
      corners_(gl::Buffer::Of(std::span<const Corner>(HandleCorners()))),
      handle_({{corners_, sizeof(Corner), {{0, 3, gl::Scalar::kFloat, 0}, {1, 2, gl::Scalar::kFloat, 12}}}},
              HandleIndices()) {
  program_.BindSampler("handles", 0);
}

Result<HandlesPass> HandlesPass::Open(const face::Cast& cast) {
  auto program = MakeProgram("handle.vert", "handle.frag");
  if (!program) return tl::unexpected(program.error());
  return HandlesPass(std::move(*program), cast);
}

float HandlesPass::ReachOf(const scene::Handles& handles) {
  if (Grown(handles.shown) == 0) return 0;
  return (kLength_m + kPullShown * kFarthestPull_m + kHead_m) * kChosen.size;
}

HandlesPass::Texels HandlesPass::Place(const scene::Handles& handles, const face::Shape& shape,
                                       std::size_t point) const {
  const Role role = RoleOf(handles, point);
  const float grown = Grown(handles.shown) * std::sqrt(role.size);
  const glm::vec3 axis = axes_[point];
  const float length_m = kDeepest_m + (kLength_m + kPullShown * PullOf(handles, point)) * grown;
  return {.root = {Mean(net_->surface, point, shape.cage) - axis * kDeepest_m, length_m},
          .axis = {axis, kHead_m * Grown(handles.shown) * role.size},
          .paint = {role.paint, role.painted}};
}

// Each handle stands along the mean normal of the points about it, not of its own vertex alone.
void HandlesPass::Straighten(const face::Shape& shape) {
  for (std::size_t i = 0; i < normals_.size(); ++i) normals_[i] = Mean(net_->surface, i, shape.cage_normals);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const glm::vec3 sum = Mean(beside_, i, normals_);
    axes_[i] = sum / std::max(glm::length(sum), 1e-6F);
  }
}

// One handle, whatever stands before it.
void HandlesPass::DrawThrough(int point) const {
  if (point < 0 || point >= static_cast<int>(handles_.size())) return;
  gl::Apply({.depth = gl::Depth::kOff, .blend = gl::Blend::kOver});
  gl::Program::Set(first_, point);
  handle_.Draw();
}

// What glimmers through is drawn first, without depth; then all handles, with depth, over it.
void HandlesPass::Draw(const scene::Handles& handles, const face::Shape& shape, Among among) {
  if (Grown(handles.shown) == 0 || handles_.empty()) return;
  Straighten(shape);
  for (std::size_t point = 0; point < handles_.size(); ++point)
    handles_[point] = Place(handles, shape, point);
  texture_.Write(static_cast<int>(handles_.size()), std::as_bytes(std::span(handles_)));
  texture_.Bind(0);
  program_.Use();
  gl::Program::Set(plain_, among == Among::kSkin ? kOnSkin : kOnWires);
  gl::Program::Set(opacity_, kGlimmer);
  DrawThrough(handles.partner);
  DrawThrough(handles.chosen);
  gl::Apply({});
  gl::Program::Set(opacity_, 1.0F);
  gl::Program::Set(first_, 0);
  handle_.DrawInstances(static_cast<int>(handles_.size()));
}

}  // namespace kaori::passes
