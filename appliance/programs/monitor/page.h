// The operators' monitor as a page of cells: what stands where, and how large. Nothing is drawn here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "appliance/programs/monitor/box.h"
#include "appliance/programs/monitor/view.h"
#include "render/image/fill.h"

namespace kaori::monitor {

// Where a line of text stands within its box.
enum class Side : std::uint8_t { kLeft, kMiddle, kRight };

// A line of text within a box, cut with dots where it is too long; without a size the box, filled.
struct Piece {
  Box box;
  image::Colour colour{};
  std::string text{};
  // Of the letters' em square; 0: no text.
  int size_px = 0;
  Side side = Side::kLeft;
  friend bool operator==(const Piece&, const Piece&) = default;
};

// A part of the page that is drawn as a whole, and only when it has changed: its ground, then its pieces.
struct Cell {
  Box box;
  image::Colour ground{};
  std::vector<Piece> pieces{};
  friend bool operator==(const Cell&, const Cell&) = default;
};

// Of one size the cells are always as many, in the same order and at the same places.
struct Page {
  // In the order of reading.
  std::vector<Cell> cells;
  // Where the face is shown, as on stage.
  Box programme;
  // Where the lip camera's picture is shown.
  Box lip_picture;
};

// The height of a line of text that matters, in pixels: a 36th of the picture's height, less on a narrow one.
int UnitOf(int width_px, int height_px);

// Lays the view out in a picture of this size, of 16 pixels at least each way. Pure.
Page LayOut(const View& view, int width_px, int height_px);

}  // namespace kaori::monitor
