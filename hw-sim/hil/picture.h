// What can be told of a screen's picture without knowing what it should show.
#pragma once

#include <string>

#include "drivers/base/result.h"

namespace kaori::hil {

struct PictureView {
  int width_px = 0;
  int height_px = 0;
  double lit = 0;          // Part of the points that are brighter than a dark room.
  int colours = 0;         // Different ones, of 4096.
  double middle_luma = 0;  // Mean of the middle ninth, 0..1.
};

// Errors: io_error (not a PNG).
Result<PictureView> LookAt(const std::string& png);

// For people: its size, its light and its shades.
std::string Words(const PictureView& picture);

// The part of the points that differ by more than a shade; 1 where sizes do. Errors: as LookAt.
Result<double> Difference(const std::string& png, const std::string& other_png);

// A face has light on it and many shades; a console, a cursor or nothing has neither.
bool ShowsAFace(const PictureView& picture);

}  // namespace kaori::hil
