// Pieces and cells that several parts of the monitor's page are made of.
#pragma once

#include <string>
#include <string_view>

#include "appliance/programs/monitor/page.h"

namespace kaori::monitor {

// How large things are, all in units of a line that matters.
struct Pen {
  int unit = 1;

  int normal() const { return unit; }
  int large() const { return unit * 7 / 5; }
  int huge() const { return unit * 5 / 2; }
  // About the width of a text: letters are counted, and not measured. What is longer all the same is cut
  // where it is drawn.
  int WidthOf(std::string_view text, int size_px) const;
};

// Adds the lines of a text within a box, from its top or in its middle; the last one that has room is cut
// where it is drawn.
// `text` is borrowed, and broken where it is wider than the box.
struct Lines {
  const std::string& text;
  int size_px = 0;
  image::Colour colour{};
  bool in_the_middle = false;
};
void AddLines(const Lines& lines, const Pen& pen, Box box, Cell& cell);

// A word on a ground of its colour, at the right end of `line`, which it is cut off.
void AddBadge(const Tag& tag, const Pen& pen, Box& line, Cell& cell);

// A word of what stands below, and at the right one of how it stands.
Cell LabelCell(const char* label, const Tag& tag, const Pen& pen, const Box& box);

// A bar from the rest to where the level is, with a line at the rest.
Cell BarCell(const Level& level, const Pen& pen, const Box& box);

}  // namespace kaori::monitor
