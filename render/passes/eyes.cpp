#include "render/passes/eyes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"
#include "render/passes/lid_heights.h"
#include "render/scene/view.h"

namespace kaori::passes {
namespace {

// The lids hide all but the front of the ball, and its shader asks for directions alone, whatever the triangles: no
// more of them than keep the ball behind its lids.
constexpr int kRings = 6;
constexpr int kSpokes = 16;
constexpr float kOpening_rad = 1.40F;

// Unit directions of a cap about +Z: ring 0 is its middle, kSpokes times over.
std::vector<glm::vec3> CapDirections() {
  std::vector<glm::vec3> directions;
  for (int ring = 0; ring <= kRings; ++ring) {
    const float away = kOpening_rad * static_cast<float>(ring) / kRings;
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const float round = 2 * std::numbers::pi_v<float> * static_cast<float>(spoke) / kSpokes;
      directions.emplace_back(std::sin(away) * std::cos(round), std::sin(away) * std::sin(round),
                              std::cos(away));
    }
  }
  return directions;
}

// Counter-clockwise seen from outside. Half of the innermost ring's triangles have two corners in one place,
// and draw nothing.
std::vector<std::uint32_t> CapTriangles() {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t spoke = 0; spoke < kSpokes; ++spoke) {
      const std::uint32_t a = ring * kSpokes + spoke;
      const std::uint32_t b = ring * kSpokes + (spoke + 1) % kSpokes;
      indices.insert(indices.end(), {a, a + kSpokes, b + kSpokes, a, b + kSpokes, b});
    }
  }
  return indices;
}

// The inverse of the gaze's turn: the shader asks where on the iris a point of the ball lies.
glm::mat3 HeadToIris(const scene::Gaze& gaze) {
  const glm::quat turn = scene::TurnOf({.yaw_rad = gaze.yaw_rad, .pitch_rad = gaze.pitch_rad});
  return glm::transpose(glm::mat3_cast(turn));
}

}  // namespace

EyesPass::EyesPass(gl::Program program, gl::Program dark, const face::Topology& topology)
    : topology_(&topology),
      program_(std::move(program)),
      dark_(std::move(dark)),
      ball_(program_.Find("ball")),
      gaze_(program_.Find("gaze")),
      lid_(program_.Find("lid")),
      iris_(program_.Find("iris")),
      white_(program_.Find("white")),
      drawn_(program_.Find("drawn")),
      answer_(program_.Find("answer")),
      dark_ball_(dark_.Find("ball")),
      dark_lid_(dark_.Find("lid")),
      directions_(gl::Buffer::Of(std::span<const glm::vec3>(CapDirections()))),
      cap_({{directions_, 12, {{0, 3, gl::Scalar::kFloat, 0}}}}, CapTriangles()) {}

Result<EyesPass> EyesPass::Open(const face::Topology& topology) {
  auto program = MakeProgram("eye.vert", "eye.frag");
  if (!program) return tl::unexpected(program.error());
  auto dark = MakeProgram("eye_dark.vert", "eye_dark.frag");
  if (!dark) return tl::unexpected(dark.error());
  return EyesPass(std::move(*program), std::move(*dark), topology);
}

// One draw for each ball: uniforms differ, the mesh is the same.
void EyesPass::Draw(const face::Shape& shape, const std::array<scene::Gaze, 2>& gaze, float pupil) const {
  gl::Apply({});
  program_.Use();
  const face::EyeSurface& eye = shape.eye_surface;
  gl::Program::Set(white_, glm::vec4(eye.white, eye.veins));
  gl::Program::Set(drawn_, glm::vec4(eye.pupil * pupil, eye.limbus, eye.spokes, eye.rings));
  gl::Program::Set(answer_, glm::vec2(eye.wet, eye.glow));
  for (std::size_t side = 0; side < 2; ++side) {
    const face::EyeBall& ball = shape.eyes[side];
    if (ball.radius_m < kNoBall_m) continue;
    // The shader compares with the distance from the gaze's axis, in radii: the sine of the iris's angle.
    const float reach = std::sin(std::min(shape.eye_look.iris_radius_m / ball.radius_m, 1.4F));
    gl::Program::Set(ball_, glm::vec4(ball.centre, ball.radius_m));
    gl::Program::Set(gaze_, HeadToIris(gaze[side]));
    gl::Program::Set(lid_, LidHeights(shape, topology_->lids[side], ball));
    gl::Program::Set(iris_, glm::vec4(shape.eye_look.iris, std::max(reach, 0.05F)));
    cap_.Draw();
  }
}

// Pushed back a little, so that iris and pupil, which lie on the ball, win. Not where lids cover it: the coarse cage
// of a shut lid lets a ball through here and there.
void EyesPass::DrawDark(const face::Shape& shape) const {
  gl::Apply({.push_back = true});
  dark_.Use();
  for (std::size_t side = 0; side < 2; ++side) {
    const face::EyeBall& ball = shape.eyes[side];
    if (ball.radius_m < kNoBall_m) continue;
    gl::Program::Set(dark_ball_, glm::vec4(ball.centre, ball.radius_m));
    gl::Program::Set(dark_lid_, LidHeights(shape, topology_->lids[side], ball));
    cap_.Draw();
  }
}

}  // namespace kaori::passes
