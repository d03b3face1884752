// What of an eyeball its lids leave open, seen from the front, and lids that shut over it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "appliance/authoring/import/depth_view.h"
#include "appliance/authoring/import/head_shape.h"

namespace kaori::import {

// The open part of a ball, column by column from its right end to its left; heights are of the lids' edges.
struct EyeOpening {
  std::vector<BallColumn> columns;
};

// None where the eye has no ball, or too little of it is seen to tell lids.
std::optional<EyeOpening> OpeningOf(const HeadShape& head, std::size_t side);

// The vertices of the head's front that are nearest to the ends and the middle of the opening.
LidMarks MarksOf(const EyeOpening& opening, const HeadShape& head, std::size_t side);

// Lids wholly shut: each vertex turns about the ball's level axis, so that it comes no nearer to it; the
// edges meet in the lower part of the opening, and the skin above and below follows.
Offsets ShutLids(const EyeOpening& opening, const HeadShape& head, std::size_t side);

}  // namespace kaori::import
