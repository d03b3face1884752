// The faces of a cast, shaped from their recipes.
#pragma once

#include <optional>
#include <vector>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/fit_lids.h"
#include "appliance/authoring/sculpt/modelled.h"
#include "appliance/authoring/sculpt/recipe.h"
#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::sculpt {

// A face as geometry alone, before it is mirrored and turned into metres.
struct ShapedFace {
  HalfShape shape;  // In centimetres; uv are those of the reference face.
  Ball eye;         // The left one.
  // Of a head whose sides differ: the whole of it, and `shape` is its left half. None: both sides are alike.
  std::optional<ModelledHead> whole{};
  // Where teeth and tongue go by the shape alone, about the reference's mouth; the recipe's own fit comes on top.
  double mouth_scale = 1;
  glm::dvec3 mouth_shift{};
};

// One for each recipe, in their order. The first recipe is the reference and must be carved, which the reader
// has seen to. Errors: invalid_argument, with the face's file before the reason.
Result<std::vector<ShapedFace>> ShapeFaces(const Cage& cage, const CastRecipe& cast);

// A face of the cast, in metres, both sides. Only what the sculptor decides is filled: name, positions,
// balls, mouth fit, gain.
face::Face MakeFace(const Cage& cage, const FaceRecipe& recipe, const ShapedFace& shaped);

}  // namespace kaori::sculpt
