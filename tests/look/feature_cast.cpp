#include "tests/look/feature_cast.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/atlas.h"
#include "appliance/authoring/appearance/looks.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/log.h"

namespace kaori::tests {
namespace {

constexpr int kTexture_px = 512;
constexpr float kLipRing = 2.9F;

template <class T>
T Must(Result<T> result) {
  if (result) return std::move(*result);
  Log("{}", result.error().message());
  std::abort();
}

// Brows are painted as wide in the middle as a stroke of a pen.
constexpr float kBrowHalfWidth_cm = 0.3F;

float Distance_cm(glm::vec2 from, glm::vec2 a, glm::vec2 b) {
  const float t = std::clamp(glm::dot(from - a, b - a) / glm::dot(b - a, b - a), 0.0F, 1.0F);
  return glm::distance(from, a + t * (b - a));
}

bool IsBrow(const appearance::BrowLook& brows, glm::vec2 uv_cm) {
  for (std::size_t i = 1; i < brows.path_cm.size(); ++i) {
    if (Distance_cm(uv_cm, brows.path_cm[i - 1], brows.path_cm[i]) < kBrowHalfWidth_cm) return true;
  }
  return false;
}

face::Texture PaintFeatures(const appearance::Atlas& atlas, const appearance::BrowLook& brows) {
  std::vector<std::uint8_t> rgba;
  for (const appearance::Texel& texel : atlas.texels) {
    const bool inside = texel.bag > 0.5F;
    const bool lip = !inside && texel.mouth_ring > kLipRing;
    const bool brow = IsBrow(brows, texel.mirrored());
    for (const bool on : {brow, lip, inside}) rgba.push_back(on ? 255 : 0);
    rgba.push_back(0);
  }
  return {.width_px = kTexture_px, .height_px = kTexture_px, .rgba = std::move(rgba)};
}

}  // namespace

face::Cast FeatureCast(std::span<const std::string_view> faces) {
  face::Cast cast = std::move(Must(show::LoadPack(KAORI_PACK)).cast);
  for (face::Texture& texture : cast.textures)
    texture = {.width_px = 1, .height_px = 1, .rgba = {0, 0, 0, 0}};
  const auto attributes = sculpt::PaintAttributesOf(sculpt::BuildCage());
  const appearance::Atlas atlas = appearance::UnrollSurface(cast.topology, attributes, kTexture_px);
  for (face::Face& face : cast.faces) {
    if (std::ranges::find(faces, face.name) == faces.end()) continue;
    const auto look = Must(appearance::ReadLook(KAORI_SHOW "/looks/" + face.name + ".toml"));
    cast.textures[static_cast<std::size_t>(face.surface.texture)] = PaintFeatures(atlas, look.brows);
    face.surface.print = 0;
    face.eye_look.lash_length_m = 0;
    face.eye_look.iris = glm::vec3(1);
    face.eye_surface = {.white = glm::vec3(1), .veins = 0, .pupil = 0, .limbus = 0, .spokes = 0, .wet = 0};
  }
  for (face::Prop& prop : cast.props) {
    const bool teeth = prop.part == face::Part::kUpperTeeth || prop.part == face::Part::kLowerTeeth;
    prop.colour = teeth || prop.part == face::Part::kTongue ? glm::vec3(0, 0, 1) : glm::vec3(0);
  }
  return cast;
}

}  // namespace kaori::tests
