#include "appliance/authoring/import/look.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/trigonometric.hpp>

#include "appliance/authoring/appearance/occlusion.h"
#include "appliance/authoring/import/picture.h"
#include "appliance/authoring/import/skin_paint.h"

namespace kaori::import {
namespace {

// Three steps, as for the cast's own faces: probes at neighbouring vertices differ by the
// coarse depth pictures.
constexpr int kLookSmoothSteps = 3;
// They are seen when the mouth is open, and measured while it is shut, where they would be black.
constexpr float kTeethOpen = 0.5F;

// The eyes throw shade into their sockets: a globe of 12 by 6 fields is ball enough.
void AddBall(const face::EyeBall& eye, appearance::Shell& shell) {
  if (!(eye.radius_m > 0)) return;
  constexpr int kAround = 12;
  constexpr int kUp = 6;
  const auto first = static_cast<Index>(shell.positions.size());
  for (int row = 0; row <= kUp; ++row)
    for (int column = 0; column < kAround; ++column) {
      const float up = glm::radians(180.0F * static_cast<float>(row) / kUp);
      const float round = glm::radians(360.0F * static_cast<float>(column) / kAround);
      const glm::vec3 way(std::sin(up) * std::cos(round), std::cos(up), std::sin(up) * std::sin(round));
      // From the upper pole to the lower one, row by row.
      shell.positions.push_back(eye.centre + eye.radius_m * way);
    }
  for (Index row = 0; row < kUp; ++row)
    for (Index column = 0; column < kAround; ++column) {
      const Index next = (column + 1) % kAround;
      const auto at = [&](Index r, Index c) { return first + r * kAround + c; };
      shell.triangles.push_back({at(row, column), at(row, next), at(row + 1, next)});
      shell.triangles.push_back({at(row, column), at(row + 1, next), at(row + 1, column)});
    }
}

}  // namespace

// Probes are the vertices themselves, along their normals; the shell is the head with its eyeballs, without
// hair, which an imported head gets later and may change.
void ShadeFaces(const std::vector<PartOf>& part, face::Cast& cast) {
  for (face::Face& face : cast.faces) {
    appearance::Shell shell{face.positions, cast.topology.triangles};
    const std::vector<glm::vec3> normals = appearance::VertexNormals(shell.positions, shell.triangles);
    std::vector<appearance::Probe> probes;
    for (std::size_t v = 0; v < normals.size(); ++v)
      probes.push_back({.position = face.positions[v], .normal = normals[v]});
    for (const face::EyeBall& eye : face.eyes) AddBall(eye, shell);
    face.occlusion = appearance::MeasureOpenness(shell, probes, {});
    appearance::SmoothOver(cast.topology.triangles, kLookSmoothSteps, face.occlusion);
    for (std::size_t v = 0; v < part.size(); ++v)
      face.occlusion[v] = std::clamp(face.occlusion[v], part[v] == PartOf::kSkin ? 0.0F : kTeethOpen, 1.0F);
  }
}

// The artist's picture is one for all heads: they share its texture coordinates.
std::string GiveSkin(const Model& model, const Heads& heads, const Lender& lender, face::Cast& cast) {
  const bool painted = lender.show != nullptr && !lender.spots.empty() && !lender.show->textures.empty();
  std::string remark = painted ? "skin: painted as the show's faces are" : "skin: plain";
  if (!model.picture.empty()) {
    auto texture = DecodePicture(model.picture);
    if (texture) {
      cast.textures = {std::move(*texture)};
      return "skin: the artist's picture";
    }
    remark += "; the artist's is " + texture.error().message();
  }
  if (!painted) {
    cast.textures = {PlainSkin(heads)};
    return remark;
  }
  const SkinPainter painter(heads, lender.spots, *lender.show);
  // Faces that are like the same one share a texture.
  std::map<std::size_t, int> known;  // The texture of each of the show's faces.
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    const std::size_t like = lender.like[i];
    const auto [texture, is_new] = known.try_emplace(like, static_cast<int>(cast.textures.size()));
    if (is_new) cast.textures.push_back(painter.Paint(like));
    const face::SurfaceLook& look = lender.show->faces[like].surface;
    cast.faces[i].surface = look;
    cast.faces[i].surface.texture = texture->second;
  }
  return remark;
}

}  // namespace kaori::import
