// Where everything of a contact sheet stands, in pixels from the upper left corner.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/sheet/plan.h"
#include "render/image/text.h"

namespace kaori::authoring {

// A rectangle of the sheet, by its upper left corner.
struct Box {
  int x_px = 0;
  // Down from the sheet's upper edge.
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
};

// A line of text in its box, cut to fit.
struct Label {
  Box box;
  std::string text;
  image::TextStyle style;
};

// Where all of one sheet goes; nothing is drawn yet.
struct Layout {
  // Of the whole sheet.
  int width_px = 0;
  int height_px = 0;
  // The pictures alone, in the order of the sheet's sections and their cells.
  std::vector<Box> cells;
  std::vector<Label> labels;
};

// `cell`: its width and height alone count. `lettering` measures the texts, which are cut to their boxes.
// Pure but for the lettering's cache.
Layout LayOut(const Sheet& sheet, const Box& cell, image::Lettering& lettering);

}  // namespace kaori::authoring
