// What the pieces of a head are: skin, eyeballs, teeth, tongue.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "appliance/authoring/import/mesh_graph.h"
#include "appliance/authoring/model/model.h"
#include "render/face/cast.h"

namespace kaori::import {

using model::Model;

// The numbers are used within one import only; no file holds them.
enum class PartOf : std::uint8_t { kSkin, kLeftEye, kRightEye, kUpperTeeth, kLowerTeeth, kTongue };
// For people: "left eye".
std::string_view NameOf(PartOf part);

// By vertex of the model. The largest piece is skin. A piece that is a ball of an eye's size (6 to 35 mm in
// radius, 8 % off at most, to one side of the middle) is that side's eye. Small pieces in the middle of the
// head that lie inside it are teeth or the tongue: by the name of their mesh, else by how the jaw's target
// moves them, else by size and height. Whatever is left (hair, lashes, ears) is skin, and drawn as it is.
// `graph` is of the model; the model's targets are looked at by their meanings.
std::vector<PartOf> FindParts(const Model& model, const MeshGraph& graph);

// The ball through all vertices of a part, by least squares; metres in the model's frame. None where
// there are fewer than eight vertices, or they lie in a plane. A cornea that stands out pulls the ball
// forward a little.
std::optional<face::EyeBall> FitBall(const Model& model, const std::vector<PartOf>& parts, PartOf part);

// Whether a part's vertices lie on one ball of an eye's size: a cornea, an iris and a white in one eye do; two heads in
// a file, a head that looks aside, or a pearl beside an eye do not. True where there is no ball.
bool IsOneBall(const Model& model, const std::vector<PartOf>& parts, PartOf part);

}  // namespace kaori::import
