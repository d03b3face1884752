// What of a head can be seen from the front.
//
// The head is drawn, as seen from far off along -Z, into a depth picture of half-millimetre cells. Without
// perspective, x and y of a cell are those of the head itself, so the answers need no camera.
#pragma once

#include <vector>

#include "appliance/authoring/import/head_shape.h"

namespace kaori::import {

// By vertex: true where nothing of the head, nor an eyeball, lies more than 1.5 mm before it. The margin
// keeps vertices that lie on the drawn surface from hiding themselves. `head` must have a vertex at least;
// time grows with the area of the triangles in cells.
std::vector<bool> SeenFromFront(const HeadShape& head);

// What is seen of an eyeball in one column of the picture: its longest stretch without a gap, from `low_m` up
// to `high_m` at `x_m`. Head axes, metres.
struct BallColumn {
  float x_m = 0;
  float low_m = 0;
  float high_m = 0;
};

// From low x to high x, half a millimetre apart; columns in which nothing is seen are left out. The skin
// alone hides the ball here; other balls are not drawn.
std::vector<BallColumn> SeenOfBall(const HeadShape& head, const face::EyeBall& ball);

}  // namespace kaori::import
