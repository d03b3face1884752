// An artist's shapes, worn by the faces of a show.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "appliance/authoring/import/bridge.h"
#include "appliance/authoring/import/heads.h"
#include "appliance/authoring/import/report.h"
#include "render/face/cast.h"

namespace kaori::import {

// Roles that shut the left and the right lids.
inline constexpr std::array<std::string_view, 2> kBlinks{"blink_left", "blink_right"};

// Adds a channel to the show's cast for each of the heads' shapes, carried over by `to_show`; "NAME (shape)" where the cast has an
// expression of that name. A shape that is a blink shuts the cast's own lids, where those have rings, instead of
// pulling at control points. Returns what the report says of each.
std::vector<ReportedShape> GiveShapes(const Heads& heads, const Bridge& to_show, face::Cast& cast);

}  // namespace kaori::import
