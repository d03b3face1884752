// What of a head can be seen from the front.
#pragma once

#include <vector>

#include "appliance/authoring/import/head_shape.h"

namespace kaori::import {

// By vertex: nothing of the head, nor an eyeball, lies more than a little before it.
std::vector<bool> SeenFromFront(const HeadShape& head);

// What is seen of a ball in one column of the picture: its longest stretch.
struct BallColumn {
  float x_m = 0;
  float low_m = 0;
  float high_m = 0;
};

// From low x to high x, evenly spaced; columns in which nothing is seen are left out.
std::vector<BallColumn> SeenOfBall(const HeadShape& head, const face::EyeBall& ball);

}  // namespace kaori::import
