#include "appliance/authoring/appearance/shade.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/occlusion.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr int kFaceSmoothing = 3;
constexpr int kPropSmoothing = 2;
// Lids stay light: their edge lies in a groove beside the ball.
constexpr float kLidFloor = 0.85F;
// Light that skin passes on reaches every fold: less looks like soot in the corners of mouth and nose.
constexpr float kSkinFloor = 0.24F;
constexpr float kHairFloor = 0.18F;
constexpr float kSkinLift_m = 0.0035F;
// Locks lie close to each other: a lift like the skin's would pass over them.
constexpr float kPropLift_m = 0.0015F;

// Teeth and tongue lie within the mouth, whose darkness is set and not measured.
bool ThrowsShade(const face::Prop& prop) {
  return prop.part == face::Part::kHair || prop.part == face::Part::kClothes;
}

// Triangles count on from what the shell has.
void Append(Shell& shell, const face::Prop& prop) {
  const auto first = static_cast<face::Index>(shell.positions.size());
  for (const face::PropVertex& v : prop.vertices) shell.positions.push_back(v.position);
  for (const face::Triangle& t : prop.triangles)
    shell.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

// The figure as it stands: the face at rest, and what it wears.
Shell ShellOf(const face::Cast& cast, const face::Face& face) {
  Shell shell{face.positions, cast.topology.triangles};
  for (const int p : face.props) {
    const face::Prop& prop = cast.props[static_cast<std::size_t>(p)];
    if (ThrowsShade(prop)) Append(shell, prop);
  }
  return shell;
}

// What is measured, held above a floor by where it is. The mouth's bag is not measured, since it is shut
// while it is: it gets a fixed 0.35.
float AdjustedOpenness(const sculpt::PaintAttributes& a, float measured) {
  if (a.bag > 0.5F) return 0.35F;
  if (std::abs(a.mouth_ring) >= 5.5F) return std::max(measured, 0.55F);
  if (std::abs(a.eye_ring) >= 4) return std::max(measured, kLidFloor);
  return std::max(measured, kSkinFloor);
}

// Both copies of a seam's vertex share one value, or the seam shows.
void JoinSeams(const std::vector<face::Index>& twin, std::vector<float>& values) {
  const std::vector<float> before = values;
  for (std::size_t i = 0; i < twin.size(); ++i) values[i] = 0.5F * (before[i] + before[twin[i]]);
}

// Both copies of a seam's vertex are probed along one normal, their sum.
void AddSkinProbes(const face::Topology& topology, const face::Face& face, std::vector<Probe>& probes) {
  const std::vector<glm::vec3> normals = VertexNormals(face.positions, topology.triangles);
  for (std::size_t i = 0; i < face.positions.size(); ++i) {
    const glm::vec3 shared = normals[i] + normals[topology.twin[i]];
    const glm::vec3 normal = glm::dot(shared, shared) > 1e-8F ? glm::normalize(shared) : normals[i];
    probes.push_back({face.positions[i], normal, kSkinLift_m});
  }
}

// Props are measured where they are, a little above themselves.
void AddPropProbes(const face::Prop& prop, std::vector<Probe>& probes) {
  for (const face::PropVertex& v : prop.vertices) probes.push_back({v.position, v.normal, kPropLift_m});
}

// Smoothed first, so that floors stay floors.
void FinishSkin(const std::vector<sculpt::PaintAttributes>& attributes, const face::Topology& topology,
                std::vector<float>& open) {
  SmoothOver(topology.triangles, kFaceSmoothing, open);
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = AdjustedOpenness(attributes[i], open[i]);
  JoinSeams(topology.twin, open);
}

// Hair is lifted to its floor and not cut off there, so that its locks still differ in the dark.
void FinishProp(std::vector<float> open, face::Prop& prop) {
  SmoothOver(prop.triangles, kPropSmoothing, open);
  const float floor = prop.part == face::Part::kHair ? kHairFloor : 0.0F;
  for (std::size_t i = 0; i < open.size(); ++i)
    prop.vertices[i].shade = Clamp01(floor + (1 - floor) * open[i]);
}

}  // namespace

void ShadeFace(const std::vector<sculpt::PaintAttributes>& attributes, int directions, face::Cast& cast,
               face::Face& face) {
  const Shell shell = ShellOf(cast, face);
  std::vector<Probe> probes;
  AddSkinProbes(cast.topology, face, probes);
  for (const int p : face.props) {
    const face::Prop& prop = cast.props[static_cast<std::size_t>(p)];
    if (ThrowsShade(prop)) AddPropProbes(prop, probes);
  }
  OcclusionSettings settings;
  settings.directions = directions;
  const std::vector<float> open = MeasureOpenness(shell, probes, settings);
  // Probes were listed as the skin's, then each prop's in order; openness comes back so.
  auto next = open.begin() + static_cast<std::ptrdiff_t>(face.positions.size());
  face.occlusion.assign(open.begin(), next);
  FinishSkin(attributes, cast.topology, face.occlusion);
  for (const int p : face.props) {
    face::Prop& prop = cast.props[static_cast<std::size_t>(p)];
    if (!ThrowsShade(prop)) continue;
    const auto end = next + static_cast<std::ptrdiff_t>(prop.vertices.size());
    FinishProp({next, end}, prop);
    next = end;
  }
}

}  // namespace kaori::appearance
