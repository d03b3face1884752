#include "appliance/authoring/inspect/teeth.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "appliance/authoring/inspect/depth_picture.h"

namespace kaori::inspect {
namespace {

// Over the teeth: a fifth of a millimetre.
constexpr int kTeethPixels = 256;
// Less is hidden by the wet line between tooth and lip.
constexpr float kThrough_m = 0.0003F;
// What stands farther out is not hidden by these lips at all: an animal's teeth before its chin.
constexpr float kBeforeTheLips = 0.02F;
// Cosine; a lip seen edge on hides nothing.
constexpr float kFacesUs = 0.2F;

// As the stage draws them (render/passes/mouth.cpp): teeth are left out while the jaw drops less than this,
// and so is a part that is hardly present.
constexpr float kShut_m = 0.0002F;
constexpr float kGone = 0.02F;

// How much of a part the face shows, 0..1; the tongue is no tooth.
float Presence(const face::MouthFit& fit, face::Part part) {
  if (part == face::Part::kUpperTeeth) return fit.upper_teeth;
  return part == face::Part::kLowerTeeth ? fit.lower_teeth : 0;
}

// Vertices of one prop where the stage would draw them: lower teeth go down with the jaw, and back by a
// quarter of that.
void AddTeeth(const face::Cast& cast, const face::Prop& prop, const face::Shape& shape,
              std::vector<glm::vec3>& teeth) {
  const float presence = Presence(shape.mouth, prop.part);
  if (presence <= kGone) return;
  const float drop_m = prop.part == face::Part::kLowerTeeth ? shape.jaw_drop_m : 0;
  const glm::vec3 offset = shape.mouth.offset + glm::vec3(0, -drop_m, -0.25F * drop_m);
  const float scale = shape.mouth.scale * (0.6F + 0.4F * presence);
  for (const face::PropVertex& v : prop.vertices)
    teeth.push_back((v.position - cast.mouth_anchor) * scale + cast.mouth_anchor + offset);
}

// Empty while the mouth is shut.
std::vector<glm::vec3> TeethOf(const face::Cast& cast, const face::Face& face, const face::Shape& shape) {
  std::vector<glm::vec3> teeth;
  if (shape.jaw_drop_m < kShut_m) return teeth;
  for (const int prop : face.props) AddTeeth(cast, cast.props[static_cast<std::size_t>(prop)], shape, teeth);
  return teeth;
}

bool TeethFacesUs(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  return normal.z > kFacesUs * glm::length(normal);
}

}  // namespace

// The picture is as large as the teeth, so that the rest of the head costs little. Where no skin was drawn
// its depth lies a thousand kilometres behind, which kBeforeTheLips leaves out.
TeethThroughLips FindTeethThroughLips(const face::Cast& cast, const face::Face& face,
                                      const face::Shape& shape, const std::vector<bool>& skin) {
  TeethThroughLips through;
  const auto teeth = TeethOf(cast, face, shape);
  if (teeth.empty()) return through;
  // Only skin that looks forwards can hide a tooth; the inside of a lip looks away.
  DepthPicture lips(WindowOver(teeth), kTeethPixels);
  const auto& triangles = cast.topology.fine.triangles;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    if (skin[i] && TeethFacesUs(shape.fine[a], shape.fine[b], shape.fine[c]))
      lips.Draw(shape.fine[a], shape.fine[b], shape.fine[c]);
  }
  for (const glm::vec3& tooth : teeth) {
    const float before_m = tooth.z - lips.At(tooth);
    if (before_m <= kThrough_m || before_m > kBeforeTheLips) continue;
    ++through.vertices;
    through.farthest_m = std::max(through.farthest_m, before_m);
  }
  return through;
}

}  // namespace kaori::inspect
