#include "render/passes/lashes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"

namespace kaori::passes {
namespace {

// Points of the strip for each column of the lid.
constexpr int kSteps = 4;
constexpr glm::vec3 kPaint{0.0075F, 0.0048F, 0.0042F};

// The vertex of the fine mesh that replaces a cage vertex: the one that leans on it most. Catmull-Clark keeps
// the cage's vertices as the first of the fine ones, with most weight on themselves.
face::Index OnFineMesh(const face::SparseRows& from_cage, face::Index cage) {
  face::Index best = 0;
  float most = -1;
  for (std::size_t row = 0; row < from_cage.rows(); ++row) {
    for (std::uint32_t k = from_cage.row_start[row]; k < from_cage.row_start[row + 1]; ++k) {
      if (from_cage.column[k] != cage || from_cage.weight[k] <= most) continue;
      most = from_cage.weight[k];
      best = static_cast<face::Index>(row);
    }
  }
  return best;
}

std::vector<face::Index> MarginOnFineMesh(const face::Topology& topology, const face::LidRig& rig) {
  std::vector<face::Index> margin;
  const std::size_t first = static_cast<std::size_t>(rig.margin_ring) * static_cast<std::size_t>(rig.columns);
  for (std::size_t j = 0; j < static_cast<std::size_t>(rig.columns); ++j) {
    margin.push_back(OnFineMesh(topology.fine.from_cage, rig.upper[first + j]));
  }
  return margin;
}

// Roots along a margin; each has a tip besides. None where there is no margin.
std::size_t StripPoints(std::size_t columns) {
  return columns < 2 ? 0 : (columns - 1) * kSteps + 1;
}

void AppendStrip(std::uint32_t first, std::size_t points, std::vector<std::uint32_t>& indices) {
  for (std::uint32_t i = 0; i + 1 < points; ++i) {
    const std::uint32_t a = first + 2 * i;
    indices.insert(indices.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
  }
}

std::vector<std::uint32_t> Strips(const std::array<std::vector<face::Index>, 2>& margins) {
  std::vector<std::uint32_t> indices;
  const std::size_t left = StripPoints(margins[0].size());
  AppendStrip(0, left, indices);
  AppendStrip(static_cast<std::uint32_t>(2 * left), StripPoints(margins[1].size()), indices);
  return indices;
}

// Catmull-Rom through the fine vertices of a margin. At the ends the outermost vertex stands for the one
// beyond.
glm::vec3 OnCurve(std::span<const glm::vec3> fine, std::span<const face::Index> margin, float column) {
  const auto last = static_cast<std::ptrdiff_t>(margin.size()) - 1;
  const auto j = std::min(static_cast<std::ptrdiff_t>(column), last - 1);
  const float t = column - static_cast<float>(j);
  const auto at = [&](std::ptrdiff_t i) {
    return fine[margin[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))]];
  };
  const glm::vec3 a = at(j - 1);
  const glm::vec3 b = at(j);
  const glm::vec3 c = at(j + 1);
  const glm::vec3 d = at(j + 2);
  return 0.5F * (2.0F * b + (c - a) * t + (2.0F * a - 5.0F * b + 4.0F * c - d) * t * t +
                 (3.0F * b - a - 3.0F * c + d) * t * t * t);
}

// None grow in the inner corner.
float Started(float t) {
  return glm::smoothstep(0.06F, 0.26F, t);
}

// From root to tip, metres, at `t` 0 the inner corner .. 1 the outer; x counts outwards from the nose.
glm::vec3 Lash(const face::EyeLook& look, float shut, float t) {
  const float bow = std::sin(0.62F * std::numbers::pi_v<float> * t);
  const float length_m = look.lash_length_m * (0.30F * Started(t) + 1.1F * std::pow(bow, 1.5F));
  const float up = 0.75F - 1.05F * shut;  // On a shut lid lashes point down and forwards.
  const float ahead = 0.75F + 0.2F * shut + 0.9F * std::max(0.0F, 0.6F - t);  // Clear of the lid's fold.
  const glm::vec3 way = glm::normalize(glm::vec3((t - 0.35F) * 1.1F, up, ahead));
  const float wing = std::pow(std::clamp((t - 0.93F) / 0.07F, 0.0F, 1.0F), 1.3F);
  return way * length_m + wing * look.lash_wing_m * glm::vec3(0.60F, 0.24F - 0.2F * shut, -0.36F);
}

}  // namespace

LashesPass::LashesPass(gl::Program program, const face::Topology& topology)
    : program_(std::move(program)),
      paint_(program_.Find("paint")),
      margins_{MarginOnFineMesh(topology, topology.lids[0]), MarginOnFineMesh(topology, topology.lids[1])},
      points_(2 * (StripPoints(margins_[0].size()) + StripPoints(margins_[1].size()))),
      buffer_(gl::BufferUse::kEachFrame, points_.size() * sizeof(glm::vec3)),
      strip_({{buffer_, 12, {{0, 3, gl::Scalar::kFloat, 0}}}}, Strips(margins_)) {}

Result<LashesPass> LashesPass::Open(const face::Topology& topology) {
  auto program = MakeProgram("lash.vert", "lash.frag");
  if (!program) return tl::unexpected(program.error());
  return LashesPass(std::move(*program), topology);
}

// One eye's strip, from the inner corner outwards.
void LashesPass::Grow(const face::Shape& shape, std::size_t side) {
  const auto& margin = margins_[side];
  const std::size_t count = StripPoints(margin.size());
  const std::size_t first = side == 0 ? 0 : 2 * StripPoints(margins_[0].size());
  const float outwards = side == 0 ? 1.0F : -1.0F;
  // Roots start below the margin of an open lid, and above that of a shut one, so that no rim of skin shows.
  const float shut = shape.lids_shut[side];
  const glm::vec3 tuck = glm::vec3(0, -0.0005F + 0.0012F * shut, 0.0002F + 0.0004F * shut) *
                         std::min(shape.eye_look.lash_length_m / 0.003F, 1.0F);
  for (std::size_t i = 0; i < count; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(count - 1);
    const glm::vec3 root = OnCurve(shape.fine, margin, static_cast<float>(i) / kSteps);
    const glm::vec3 lash = Lash(shape.eye_look, shape.lids_shut[side], t);
    points_[first + 2 * i] = root + tuck * Started(t);
    points_[first + 2 * i + 1] = root + lash * glm::vec3(outwards, 1, 1);
  }
}

// Both sides of the strip are drawn: it is seen from below, too.
void LashesPass::Draw(const face::Shape& shape) {
  constexpr float kUnseen_m = 1e-4F;
  if (points_.empty() || shape.fine.empty() || shape.eye_look.lash_length_m < kUnseen_m) return;
  Grow(shape, 0);
  Grow(shape, 1);
  buffer_.Write(std::as_bytes(std::span(points_)));
  gl::Apply({.cull = gl::Cull::kNone});
  program_.Use();
  gl::Program::Set(paint_, kPaint);
  strip_.Draw();
}

}  // namespace kaori::passes
