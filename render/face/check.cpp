#include "render/face/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

#include <fmt/format.h>

#include "render/face/faults.h"

namespace kaori::face {
namespace {

// A head beyond this was not made in metres.
constexpr float kFarthest_m = 10;
// The least that graphics units of this time take.
constexpr int kWidestTexture_px = 8192;

// False for what is no number, too.
bool Is0To1(float value) {
  return value >= 0 && value <= 1;
}

// The interpolant moves exactly the vertices that can move; each point lies on the face and in the unit
// square.
void CheckNet(const Cast& cast, Faults& faults) {
  const ControlNet& net = cast.net;
  const std::size_t points = net.points.size();
  const std::size_t moving = cast.topology.moving_count;
  faults.Rows("control points to cage", net.to_cage, moving, points);
  faults.Rows("control points on the surface", net.surface, points, cast.topology.vertex_count);
  for (const ControlPoint& point : net.points) {
    if (Is0To1(point.uv.x) && Is0To1(point.uv.y)) continue;
    faults.Add(fmt::format("control point \"{}\": lies outside the parameter space", point.name));
  }
}

// A face without an eye has a ball of radius 0: that is no fault.
void CheckEyes(const std::string& item, const Face& face, Faults& faults) {
  for (const EyeBall& eye : face.eyes) {
    const bool good = IsFinite(eye.centre) && std::isfinite(eye.radius_m) && eye.radius_m >= 0 &&
                      std::isfinite(eye.lid_thickness_m);
    if (!good) faults.Add(item + ": an eye has no position or size");
  }
}

// What is blended with a face, and what its surface answers to light.
void CheckLook(const std::string& item, const Face& face, Faults& faults) {
  const EyeLook& eye = face.eye_look;
  const MouthFit& mouth = face.mouth;
  const SurfaceLook& surface = face.surface;
  const EyeSurface& ball = face.eye_surface;
  const std::array numbers{eye.iris.x,        eye.iris.y,       eye.iris.z,           eye.iris_radius_m,
                           eye.lash_length_m, eye.lash_wing_m,  mouth.scale,          mouth.offset.x,
                           mouth.offset.y,    mouth.offset.z,   mouth.upper_teeth,    mouth.lower_teeth,
                           mouth.tongue,      surface.softness, surface.metal,        surface.flat.x,
                           surface.flat.y,    surface.flat.z,   face.expression_gain, ball.white.x,
                           ball.white.y,      ball.white.z,     ball.veins,           ball.pupil,
                           ball.limbus,       ball.spokes,      ball.rings,           ball.wet,
                           ball.glow};
  faults.Finite(item + ", its look", numbers);
  if (!Is0To1(surface.print)) faults.Add(item + ": its print is not within 0 to 1");
  if (!Is0To1(surface.folds)) faults.Add(item + ": its folds are not within 0 to 1");
  if (!Is0To1(face.surface.flush)) faults.Add(item + ": its flush is not within 0 to 1");
}

// Without textures at all (a cast in work) the index is not looked at.
void CheckFace(const Cast& cast, const Face& face, Faults& faults) {
  const std::string item = fmt::format("face \"{}\"", face.name);
  const std::size_t vertices = cast.topology.vertex_count;
  if (face.positions.size() != vertices) {
    faults.Add(fmt::format("{}: {} vertices, the topology has {}", item, face.positions.size(), vertices));
  }
  const bool finite = faults.Finite(item, face.positions);
  const auto far = [](const glm::vec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kFarthest_m;
  };
  if (finite && std::ranges::any_of(face.positions, far))
    faults.Add(item + ": is larger than 10 m; are these metres?");
  if (!face.occlusion.empty()) faults.Size(item + ", occlusion", face.occlusion.size(), vertices);
  faults.Finite(item + ", occlusion", face.occlusion);
  if (!face.withdrawn.empty())
    faults.Size(item + ", withdrawn", face.withdrawn.size(), cast.topology.outgrowth.size());
  faults.Finite(item + ", withdrawn", face.withdrawn);
  if (!face.hang_arms_m.empty())
    faults.Size(item + ", arms of what hangs", face.hang_arms_m.size(), cast.topology.outgrowth.size());
  if (std::ranges::any_of(face.hang_arms_m, [](glm::vec2 arms) {
        return !(std::abs(arms.x) <= kFarthest_m) || !(std::abs(arms.y) <= kFarthest_m);
      }))
    faults.Add(item + ": an arm of what hangs is no length below 10 m");
  if (!Is0To1(face.outgrowth_kind)) faults.Add(item + ": its kind of outgrowth is not within 0 to 1");
  const std::span<const Index> corners(face.sparse.empty() ? nullptr : face.sparse.front().data(),
                                       face.sparse.size() * 3);
  faults.Indices(item + ", sparse triangles", corners, cast.topology.fine.from_cage.rows());
  CheckEyes(item, face, faults);
  CheckLook(item, face, faults);
  const auto within = [](int index, std::size_t count) {
    return index >= 0 && static_cast<std::size_t>(index) < count;
  };
  if (!cast.textures.empty() && !within(face.surface.texture, cast.textures.size())) {
    faults.Add(fmt::format("{}: texture {} is missing", item, face.surface.texture));
  }
  for (const int prop : face.props) {
    if (!within(prop, cast.props.size())) faults.Add(fmt::format("{}: prop {} is missing", item, prop));
  }
}

// A kind comes from a file as a number, and may be any.
void CheckExpression(const Cast& cast, const Expression& expression, Faults& faults) {
  const std::string item = fmt::format("expression \"{}\"", expression.name);
  if (expression.kind > ExpressionKind::kChannel) faults.Add(item + ": is of a kind that does not exist");
  faults.Size(item, expression.displacement.size(), cast.net.points.size());
  faults.Finite(item, expression.displacement);
  if (!expression.residual.empty())
    faults.Size(item + ", residual", expression.residual.size(), cast.topology.moving_count);
  faults.Finite(item + ", residual", expression.residual);
  if (!std::ranges::all_of(expression.lids, Is0To1)) faults.Add(item + ": its lids are not within 0 to 1");
  if (!(expression.pupil >= 0.5F && expression.pupil <= 1.5F))
    faults.Add(item + ": its pupils are not within 0.5 to 1.5");
  if (!Is0To1(expression.flush)) faults.Add(item + ": its flush is not within 0 to 1");
}

// The first triangle that is wrong is named, and no further one.
void CheckProp(const Prop& prop, Faults& faults) {
  const std::string item = fmt::format("prop \"{}\"", prop.name);
  if (prop.part > Part::kClothes) faults.Add(item + ": is a part that does not exist");
  if (!IsFinite(prop.colour)) faults.Add(item + ": its colour is not a number");
  for (const Triangle& t : prop.triangles) {
    if (faults.Indices(item, t, prop.vertices.size())) continue;
    break;
  }
  const auto wrong = [](const PropVertex& v) {
    return !IsFinite(v.position) || !IsFinite(v.normal) || !IsFinite(v.tangent) ||
           !std::isfinite(v.along + v.across + v.shade);
  };
  if (std::ranges::any_of(prop.vertices, wrong)) faults.Add(item + ": a vertex holds what is not a number");
}

// Sizes first: they say how many bytes there must be.
void CheckTexture(std::size_t index, const Texture& texture, Faults& faults) {
  const std::string item = fmt::format("texture {}", index);
  if (texture.width_px <= 0 || texture.height_px <= 0) {
    faults.Add(item + ": has no size");
    return;
  }
  if (std::max(texture.width_px, texture.height_px) > kWidestTexture_px)
    faults.Add(fmt::format("{}: is larger than {} pixels a side", item, kWidestTexture_px));
  const std::size_t pixels =
      static_cast<std::size_t>(texture.width_px) * static_cast<std::size_t>(texture.height_px);
  faults.Size(item + ", bytes", texture.rgba.size(), 4 * pixels);
}

}  // namespace

// Sizes and indices of the topology first: the other checks count on none of them, but people read
// from the top.
std::vector<std::string> FindFaults(const Cast& cast) {
  Faults faults;
  CheckTopology(cast.topology, faults);
  CheckNet(cast, faults);
  if (cast.faces.empty()) faults.Add("cast: has no face");
  if (cast.expressions.empty()) faults.Add("cast: has no expression");
  for (const Face& face : cast.faces) CheckFace(cast, face, faults);
  for (const Expression& expression : cast.expressions) CheckExpression(cast, expression, faults);
  for (const int blink : cast.blink) {
    if (blink >= static_cast<int>(cast.expressions.size()) || blink < -1)
      faults.Add(fmt::format("blink: there is no expression {}", blink));
  }
  for (const Prop& prop : cast.props) CheckProp(prop, faults);
  for (std::size_t i = 0; i < cast.textures.size(); ++i) CheckTexture(i, cast.textures[i], faults);
  if (!IsFinite(cast.neck_pivot) || !IsFinite(cast.mouth_anchor))
    faults.Add("cast: the neck or the mouth has no position");
  return faults.Release();
}

}  // namespace kaori::face
