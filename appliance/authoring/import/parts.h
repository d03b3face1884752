// What the pieces of a head are: skin, eyeballs, teeth, tongue.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "appliance/authoring/import/mesh_graph.h"
#include "appliance/authoring/import/model.h"
#include "render/face/cast.h"

namespace kaori::import {

enum class PartOf : std::uint8_t { kSkin, kLeftEye, kRightEye, kUpperTeeth, kLowerTeeth, kTongue };
std::string_view NameOf(PartOf part);

// By vertex of the model. The largest piece is skin. A piece that is a ball of an eye's size and has a mirror
// image is an eye. Small pieces in the middle of the head that lie inside it are teeth or the tongue: by the
// name of their mesh, else by how the jaw's target moves them, else by size and height. Whatever is left is
// skin, and drawn as it is.
std::vector<PartOf> FindParts(const Model& model, const MeshGraph& graph);

// The ball through vertices of a part, by least squares; none where there are too few.
std::optional<face::EyeBall> FitBall(const Model& model, const std::vector<PartOf>& parts, PartOf part);

}  // namespace kaori::import
