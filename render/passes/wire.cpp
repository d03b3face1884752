#include "render/passes/wire.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"
#include "render/passes/lid_heights.h"
#include "render/scene/view.h"

namespace kaori::passes {
namespace {

// Width of the texture of points, as wire.vert.
constexpr int kTexture_px = 64;
// Points of a circle.
constexpr std::size_t kCircle = 40;
// Iris and pupil of two eyes.
constexpr std::size_t kCircles = 4;
// Beyond white: cyan pales.
constexpr float kEyeBrightness = 2.6F;

// In radii of the ball: so near to a lid's margin a circle fades.
constexpr float kLidFades = 0.06F;

// Lines fade in over this part of the parameter space's height: the neck, which has no end in the picture.
// As wire_body.vert.
constexpr float kFadedBelow = 0.01F;
constexpr float kSeenAbove = 0.15F;

// From the height in texture coordinates: 0 where the neck ends, 1 above it. Vertices without such
// coordinates do not fade.
std::vector<float> FadesOf(const face::Topology& topology) {
  std::vector<float> fades;
  for (const glm::vec2& place : topology.texture) {
    const float seen = glm::smoothstep(kFadedBelow, kSeenAbove, place.y);
    fades.push_back(seen * seen);
  }
  fades.resize(topology.vertex_count, 1.0F);
  return fades;
}

// Lines glow in the colour of the flat-shaded face, deeper and as bright as can be.
std::vector<glm::vec3> GlowsOf(const face::Cast& cast) {
  std::vector<glm::vec3> glows;
  for (const face::Face& f : cast.faces) {
    const glm::vec3 flat = f.surface.flat;
    const float most = std::max({flat.r, flat.g, flat.b});
    glows.push_back(most > 0 ? glm::pow(flat / most, glm::vec3(1.6F)) : glm::vec3(1));
  }
  return glows;
}

// How much of a point of the ball's surface the lids leave to be seen, 0..1. `way` is its direction from the centre,
// head's frame. Depth would not tell: lines are drawn a little nearer than what they lie on, and lids are thin.
float BetweenLids(const LidHeightsOf& heights, const glm::vec3& way) {
  const auto off = [](float over) { return glm::smoothstep(0.0F, kLidFades, over); };
  return off(LidHeight(heights, Lid::kUpper, way.x) - way.y) *
         off(way.y - LidHeight(heights, Lid::kLower, way.x));
}

// A line is a ribbon of two triangles that turns to the viewer (wire.vert): GLES draws wide lines on few
// drivers.
struct RibbonCorner {
  std::uint32_t ends[2];
  glm::vec2 corner;
};

void AppendRibbon(std::uint32_t from, std::uint32_t to, std::vector<RibbonCorner>& corners) {
  constexpr glm::vec2 kCorners[] = {{0, -1}, {0, 1}, {1, -1}, {1, 1}};
  for (const glm::vec2& corner : kCorners) corners.push_back({{from, to}, corner});
}

// Four corners a line, each with both ends' numbers: the shader finds its direction in the picture.
std::vector<RibbonCorner> RibbonCorners(const face::Topology& topology) {
  std::vector<RibbonCorner> corners;
  for (const face::Line& line : topology.wires) AppendRibbon(line[0], line[1], corners);
  for (std::uint32_t circle = 0; circle < kCircles; ++circle) {
    const auto first = static_cast<std::uint32_t>(topology.vertex_count + circle * std::uint32_t{kCircle});
    for (std::uint32_t i = 0; i < kCircle; ++i)
      AppendRibbon(first + i, first + (i + 1) % std::uint32_t{kCircle}, corners);
  }
  return corners;
}

// Two triangles for each ribbon of four corners, with the diagonal from its corner 0 to its corner 3.
std::vector<std::uint32_t> RibbonIndices(std::size_t ribbons) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t r = 0; r < ribbons; ++r) {
    const std::uint32_t a = 4 * r;
    indices.insert(indices.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
  }
  return indices;
}

int TextureRows(std::size_t points) {
  return static_cast<int>((points + kTexture_px - 1) / static_cast<std::size_t>(kTexture_px));
}

std::size_t RibbonCount(const face::Topology& topology) {
  return topology.wires.size() + kCircles * kCircle;
}

}  // namespace

WirePass::WirePass(gl::Program body, gl::Program lines, const face::Cast& cast)
    : body_(std::move(body)),
      lines_(std::move(lines)),
      body_paint_(body_.Find("paint")),
      lines_paint_(lines_.Find("paint")),
      glows_(GlowsOf(cast)),
      lids_(cast.topology.lids),
      cage_points_(cast.topology.vertex_count),
      fades_(FadesOf(cast.topology)),
      points_(static_cast<std::size_t>(TextureRows(cage_points_ + kCircles * kCircle) * kTexture_px)),
      texture_(
          {.width_px = kTexture_px, .height_px = TextureRows(points_.size()), .texels = gl::Texels::kFloat4}),
      corners_(gl::Buffer::Of(std::span<const RibbonCorner>(RibbonCorners(cast.topology)))),
      ribbons_(
          {{corners_, sizeof(RibbonCorner), {{0, 2, gl::Scalar::kUInt, 0}, {1, 2, gl::Scalar::kFloat, 8}}}},
          RibbonIndices(RibbonCount(cast.topology))) {
  lines_.BindSampler("points", 0);
}

Result<WirePass> WirePass::Open(const face::Cast& cast) {
  auto body = MakeProgram("wire_body.vert", "wire_body.frag");
  if (!body) return tl::unexpected(body.error());
  auto lines = MakeProgram("wire.vert", "wire.frag");
  if (!lines) return tl::unexpected(lines.error());
  return WirePass(std::move(*body), std::move(*lines), cast);
}

// Two circles: the edge of the iris, and the pupil.
void WirePass::WriteEye(const face::Shape& shape, std::size_t side, const scene::Gaze& gaze,
                        glm::vec4* points) const {
  const face::EyeBall& ball = shape.eyes[side];
  if (ball.radius_m < kNoBall_m) {
    std::fill_n(points, 2 * kCircle, glm::vec4(ball.centre, 0));
    return;
  }
  const LidHeightsOf heights = LidHeights(shape, lids_[side], ball);
  const glm::quat turn = scene::TurnOf({.yaw_rad = gaze.yaw_rad, .pitch_rad = gaze.pitch_rad});
  for (const float part : {0.92F, 0.40F}) {
    // An angle at the ball's centre: part of the iris's arc.
    const float away = part * shape.eye_look.iris_radius_m / ball.radius_m;
    for (std::size_t i = 0; i < kCircle; ++i) {
      const float round = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kCircle;
      const glm::vec3 way{std::sin(away) * std::cos(round), std::sin(away) * std::sin(round), std::cos(away)};
      const glm::vec3 turned = turn * way;
      *points++ =
          glm::vec4(ball.centre + turned * ball.radius_m, kEyeBrightness * BetweenLids(heights, turned));
    }
  }
}

// Vertices have no index into a buffer of other vertices, so both ends of a line are looked up in a texture
// of points.
void WirePass::WritePoints(const face::Shape& shape, const std::array<scene::Gaze, 2>& gaze) {
  for (std::size_t i = 0; i < cage_points_; ++i) points_[i] = glm::vec4(shape.cage[i], fades_[i]);
  for (std::size_t side = 0; side < 2; ++side) {
    WriteEye(shape, side, gaze[side], &points_[cage_points_ + side * 2 * kCircle]);
  }
  texture_.Write(TextureRows(points_.size()), std::as_bytes(std::span(points_)));
}

// The mean of the faces' glows by their weights.
glm::vec3 WirePass::Paint(const face::Terms& faces) const {
  glm::vec3 paint{};
  for (const face::Term& term : faces) paint += term.weight * glows_[term.index];
  return paint;
}

// The body is pushed back a little in depth, or it would cover the lines that lie on it.
void WirePass::Draw(const Surface& surface, const face::Shape& shape,
                    const std::array<scene::Gaze, 2>& gaze) {
  WritePoints(shape, gaze);
  const glm::vec3 paint = Paint(shape.faces);
  gl::Apply({.cull = gl::Cull::kNone, .push_back = true});
  body_.Use();
  gl::Program::Set(body_paint_, paint);
  surface.cage().Draw();
  // The larger of both, so that lines that cross do not add up to a knot of light.
  gl::Apply({.cull = gl::Cull::kNone, .depth = gl::Depth::kTestOnly, .blend = gl::Blend::kBrightest});
  texture_.Bind(0);
  lines_.Use();
  gl::Program::Set(lines_paint_, paint);
  ribbons_.Draw();
}

}  // namespace kaori::passes
