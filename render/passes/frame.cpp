#include "render/passes/frame.h"

#include <algorithm>
#include <cmath>

#include "render/passes/shader_library.h"
#include "render/scene/view.h"

namespace kaori::passes {
namespace {

// Of the reference face, from the lower edge of its neck: inside the collar, and just below the chin.
constexpr float kStill_m = 0.016F;
constexpr float kTurns_m = 0.062F;

// Of the reference face, from its collar to where its neck turns wholly.
constexpr float kOverCollar_m = 0.012F;

// As frame.glsl.
constexpr float kLeanPerMetre = 3.3F;

// Full breath lifts the shoulders by this much.
constexpr float kBreath_m = 0.004F;

// From the camera's right, low: cool, opposite to the key light.
constexpr glm::vec3 kFillLight{0.80F, 0.10F, 0.50F};

// Above the point about which the head turns, and before it: the middle of what throws shadows; and how far they
// are followed from there, across the light and along it.
constexpr glm::vec3 kShadowed_m{0, 0.07F, 0.02F};
constexpr float kShadowReach_m = 0.24F;
constexpr float kShadowDepth_m = 0.40F;

// Parallel light from `towards`, a unit vector in the camera's frame. Its own axes: x and y across it, z towards
// the lamp, whose clip space counts depth the other way.
glm::mat4 LampOf(glm::vec3 towards, glm::vec3 middle_m) {
  const glm::vec3 aside = std::abs(towards.y) < 0.99F ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
  const glm::vec3 x = glm::normalize(glm::cross(aside, towards));
  const glm::vec3 y = glm::cross(towards, x);
  glm::mat4 lamp(1);
  for (int axis = 0; axis < 3; ++axis) {
    lamp[axis] = {x[axis] / kShadowReach_m, y[axis] / kShadowReach_m, -towards[axis] / kShadowDepth_m, 0};
  }
  lamp[3] = {0, 0, 0, 1};
  lamp[3] = lamp * glm::vec4(-middle_m, 1);
  return lamp;
}

}  // namespace

// The lower edge of the reference face's neck is the lowest vertex of all.
Neck NeckOf(const face::Cast& cast) {
  const auto& reference = cast.faces.front().positions;
  const auto lower = [](const glm::vec3& a, const glm::vec3& b) { return a.y < b.y; };
  const float edge_m = std::min_element(reference.begin(), reference.end(), lower)->y;
  return {cast.neck_pivot, edge_m + kStill_m, edge_m + kTurns_m};
}

Neck AboveCollar(Neck neck, float collar_m) {
  const float raised_m = std::max(collar_m + kOverCollar_m - neck.turns_above_m, 0.0F);
  neck.still_below_m += raised_m;
  neck.turns_above_m += raised_m;
  return neck;
}

// Numbers that share a vec4 are there to fill std140's padding.
FrameBlock MakeFrame(const scene::Scene& scene, const Neck& neck, glm::vec2 layer_px, float soft_share) {
  FrameBlock f{};
  f.view = scene::ViewOf(scene.camera);
  f.projection = scene::ProjectionOf(scene.camera, layer_px.x / layer_px.y);
  const glm::quat turn = scene::TurnOf(scene.head);
  f.turn = {turn.x, turn.y, turn.z, turn.w};
  f.pivot = {neck.pivot, neck.still_below_m};
  f.shift = {scene.head.shift_m, neck.turns_above_m};
  f.key = {glm::normalize(scene.light.key), scene.light.exposure};
  f.fill = {glm::normalize(kFillLight), soft_share};
  f.up = {glm::mat3(f.view) * glm::vec3(0, 1, 0), scene.breath * kBreath_m};
  const auto sway = [&](scene::HairPart part) { return scene.hair_sway_rad[static_cast<std::size_t>(part)]; };
  f.sway = {sway(scene::HairPart::kFringe), layer_px};
  f.sway_sides = {sway(scene::HairPart::kLeft), sway(scene::HairPart::kRight)};
  const glm::vec3 shadowed_m = neck.pivot + kShadowed_m + scene.head.shift_m;
  f.lamp = LampOf(glm::vec3(f.key), glm::vec3(f.view * glm::vec4(shadowed_m, 1)));
  return f;
}

// Of a pixel with one sample, more than a half must be covered.
FrameBlock MakeFrame(const scene::Scene& scene, const Neck& neck, const gl::Canvas& canvas,
                     float soft_share) {
  FrameBlock f =
      MakeFrame(scene, neck, glm::vec2(canvas.layer_width_px(), canvas.layer_height_px()), soft_share);
  if (!canvas.has_samples()) f.least.x = 0.5F;
  return f;
}

float LeanShare(const FrameBlock& f, float height_m) {
  return std::clamp(1 - (f.shift.w - height_m) * kLeanPerMetre, 0.0F, 1.0F);
}

// As HeadToCamera in frame.glsl, without breath, for which callers leave a margin.
glm::vec3 Placed(const FrameBlock& f, glm::vec3 point, Follows follows) {
  const float share = follows == Follows::kHead ? 1.0F : LeanShare(f, point.y);
  if (follows != Follows::kBody) {
    // glm's constructor wants w first; the block holds x, y, z, w, as shaders read it.
    const glm::quat turn(f.turn.w, f.turn.x, f.turn.y, f.turn.z);
    point = turn * (point - glm::vec3(f.pivot)) + glm::vec3(f.pivot);
  }
  return point + share * glm::vec3(f.shift);
}

glm::vec2 Project(const FrameBlock& f, glm::vec3 point, Follows follows) {
  const glm::vec4 clip = f.projection * f.view * glm::vec4(Placed(f, point, follows), 1);
  return glm::vec2(clip) / std::max(clip.w, 1e-3F);
}

float HeightOnLayer_px(const FrameBlock& f, glm::vec3 point, Follows follows) {
  return (0.5F + 0.5F * Project(f, point, follows).y) * f.sway.w;
}

Result<gl::Program> MakeProgram(std::string_view vertex, std::string_view fragment, std::string defines) {
  auto program = gl::Program::Make(
      {.library = ShaderLibrary(), .vertex = vertex, .fragment = fragment, .defines = std::move(defines)});
  if (program) program->BindBlock("Frame", kFrameBinding);
  return program;
}

}  // namespace kaori::passes
