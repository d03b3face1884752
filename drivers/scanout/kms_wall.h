// Arranges screens side by side, so that they show one picture together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/scanout/kms_output.h"

namespace kaori::scanout {

// A screen, and where its part of the picture begins: pixels from the left top.
struct KmsPanel {
  KmsOutput output;
  int x_px = 0;
  int y_px = 0;
};

// The screens of the show as one picture, and those that are not part of it.
struct KmsWall {
  // In the order of the picture's parts, from the left top.
  std::vector<KmsPanel> panels;
  // Of the whole picture, cells without a screen included.
  int width_px = 0;
  int height_px = 0;
  std::optional<KmsOutput> status{}, monitor{};  // The displays beside it, where there are any.
};

// Arranges the screens row by row from the left top, in the order given: one beside the other, or in a
// full rectangle where their number makes one with at least as many columns as rows (4, 6, 8, 9 ...). A
// column is as wide as its widest screen, a row as high as its highest; a screen that is smaller than
// its cell stands at the cell's left top, and what lies beside it is drawn for nobody. Pure.
KmsWall Arrange(std::vector<KmsOutput> outputs);

// Its screens for people, separated by semicolons, the displays beside it last. All count as plugged in.
std::string Describe(const KmsWall& wall);

// The screen with the most pixels: where memory is short, its mode is the one to give up. `wall` has one.
const KmsOutput& Largest(const KmsWall& wall);

}  // namespace kaori::scanout
