// Where everything of a contact sheet stands, in pixels from the upper left corner.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/sheet/plan.h"
#include "render/image/text.h"

namespace kaori::authoring {

struct Box {
  int x_px = 0;
  int y_px = 0;  // Down.
  int width_px = 0;
  int height_px = 0;
};

// A line of text in its box, cut to fit.
struct Label {
  Box box;
  std::string text;
  image::TextStyle style;
};

struct Layout {
  int width_px = 0;
  int height_px = 0;
  std::vector<Box> cells;  // The pictures alone, in the order of the sheet's sections.
  std::vector<Label> labels;
};

// `cell`: its width and height.
Layout LayOut(const Sheet& sheet, const Box& cell, image::Lettering& lettering);

}  // namespace kaori::authoring
