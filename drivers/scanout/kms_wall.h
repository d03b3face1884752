// Screens side by side that show one picture together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/scanout/kms_output.h"

namespace kaori::scanout {

// A screen's part of the picture, from the left top.
struct KmsPanel {
  KmsOutput output;
  int x_px = 0;
  int y_px = 0;
};

struct KmsWall {
  std::vector<KmsPanel> panels;
  int width_px = 0;
  int height_px = 0;
  std::optional<KmsOutput> sign;  // Shows no part of the picture.
};

// Row by row from the left top, in the order given: one beside the other, or in a full rectangle where their
// number makes one that is wider than high (4, 6, 8, 9 ...). Each stands at the left top of its place.
KmsWall Arrange(std::vector<KmsOutput> outputs);

// For people: its screens, one after the other, the sign last.
std::string Describe(const KmsWall& wall);

}  // namespace kaori::scanout
