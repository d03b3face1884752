#include "appliance/atelier/import/look.h"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "appliance/atelier/import/picture.h"
#include "appliance/atelier/import/skin_paint.h"
#include "appliance/atelier/wardrobe/occlusion.h"

namespace kaori::import {
namespace {

constexpr int kSmoothSteps = 3;

// The eyes throw shade into their sockets: an octahedron, halved twice, is ball enough.
void AddBall(const face::EyeBall& eye, wardrobe::Shell& shell) {
  if (!(eye.radius_m > 0)) return;
  constexpr int kAround = 12;
  constexpr int kUp = 6;
  const auto first = static_cast<Index>(shell.positions.size());
  for (int row = 0; row <= kUp; ++row)
    for (int column = 0; column < kAround; ++column) {
      const float up = glm::radians(180.0F * static_cast<float>(row) / kUp);
      const float round = glm::radians(360.0F * static_cast<float>(column) / kAround);
      const glm::vec3 way(std::sin(up) * std::cos(round), std::cos(up), std::sin(up) * std::sin(round));
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

void ShadeFaces(face::Cast& cast) {
  for (face::Face& face : cast.faces) {
    wardrobe::Shell shell{face.positions, cast.topology.triangles};
    const std::vector<glm::vec3> normals = wardrobe::VertexNormals(shell.positions, shell.triangles);
    std::vector<wardrobe::Probe> probes;
    for (std::size_t v = 0; v < normals.size(); ++v)
      probes.push_back({.position = face.positions[v], .normal = normals[v]});
    for (const face::EyeBall& eye : face.eyes) AddBall(eye, shell);
    face.occlusion = wardrobe::MeasureOpenness(shell, probes, {});
    wardrobe::SmoothOver(cast.topology.triangles, kSmoothSteps, face.occlusion);
    for (float& open : face.occlusion) open = std::clamp(open, 0.0F, 1.0F);
  }
}

std::string GiveSkin(const Model& model, const Heads& heads, const std::vector<Spot>& spots,
                     const face::Cast* show, face::Cast& cast) {
  std::string remark = spots.empty() ? "skin: plain" : "skin: painted as the show's first face";
  if (!model.picture.empty()) {
    auto texture = DecodePicture(model.picture);
    if (texture) {
      cast.textures = {std::move(*texture)};
      return "skin: the artist's picture";
    }
    remark += "; the artist's is " + texture.error().message();
  }
  cast.textures = {PaintSkin(heads, spots, show)};
  return remark;
}

}  // namespace kaori::import
