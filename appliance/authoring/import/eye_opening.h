// What of an eyeball its lids leave open, seen from the front, and lids that shut over it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "appliance/authoring/import/depth_view.h"
#include "appliance/authoring/import/head_shape.h"

namespace kaori::import {

// The open part of a ball, column by column from low x to high x; `low_m` and `high_m` of a column are the
// heights of the lids' edges.
struct EyeOpening {
  std::vector<BallColumn> columns;
};

// `side`: 0 the character's left (+X), 1 the right. None where the eye has no ball, or where less than half
// its radius is seen in width: such an eye is shut or hidden, and its edges cannot be told.
std::optional<EyeOpening> OpeningOf(const HeadShape& head, std::size_t side);

// The vertices of the head's front that are nearest to the ends and the middle of the opening; inner is the
// end that is nearer to the nose.
LidMarks MarksOf(const EyeOpening& opening, const HeadShape& head, std::size_t side);

// Lids wholly shut: each vertex turns about the ball's level axis, so that it comes no nearer to it; the
// edges meet in the lower part of the opening, and the skin above and below follows. By vertex, zero
// where nothing moves. The offset is the end of that arc; a half blink goes along its chord, a little
// nearer to the ball.
Offsets ShutLids(const EyeOpening& opening, const HeadShape& head, std::size_t side);

}  // namespace kaori::import
