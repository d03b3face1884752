// What can be told of a screen's picture without knowing what it should show.
#pragma once

#include <array>
#include <string>

#include "drivers/base/result.h"

namespace kaori::hil {

// What can be said of any picture: enough to tell a face from a console.
struct PictureView {
  // Of the whole picture.
  int width_px = 0;
  int height_px = 0;
  // Part of the pixels that are brighter than near black, 0..1.
  double lit = 0;
  // Different ones, of 4096.
  int colours = 0;
  // Mean of the middle ninth, 0..1.
  double middle_luma = 0;
};

// Reads a picture and measures it. Errors: io_error (neither PNG nor binary PPM).
Result<PictureView> LookAt(const std::string& png);

// Describes its size, its lit part and its number of colours in one line.
std::string Describe(const PictureView& picture);

// How far two pictures differ: the mean over their pixels and colours, 0 (equal) to 1 (black against white).
// Sizes may differ: both are sampled on a grid by their height, from the middle, as a still is laid over a
// screen. Files are PNG or binary PPM. Errors: io_error (not such a picture).
Result<double> MeanDifference(const std::string& file, const std::string& other);

// The part of the pixels that differ by more than a shade, 0..1; 1 where sizes differ. Errors: as
// MeanDifference.
Result<double> ChangedPart(const std::string& file, const std::string& other);

// How many rows of the status display's picture (appliance/programs/status/sheet.h) have a mark of this
// colour. Errors: as MeanDifference.
Result<int> CountMarks(const std::string& file, const std::array<int, 3>& colour);

// Writes one picture upside down, and one that is black, of the size of `file`, as PNG: controls of a
// comparison. Errors: as MeanDifference, and those of writing.
Result<void> WriteUpsideDown(const std::string& file, const std::string& target);
Result<void> WriteBlack(const std::string& file, const std::string& target);

// A face has lit pixels and many colours; a console, a cursor or a blank screen has not. It does not
// know what a face is: a check that needs more compares with a picture. Pure.
bool ShowsAFace(const PictureView& picture);

}  // namespace kaori::hil
