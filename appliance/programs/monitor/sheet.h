// The operators' monitor as a picture: cells that are drawn one at a time, and two pictures beside them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "appliance/programs/monitor/page.h"
#include "drivers/ports/side_display.h"
#include "render/image/png.h"
#include "render/image/text.h"

namespace kaori::monitor {

// A picture from elsewhere: R, G, B and something, top row first. Borrowed.
struct Pixels {
  int width_px = 0;
  int height_px = 0;
  std::span<const std::uint8_t> rgbx;
};

// Used by one thread. It remembers what each cell shows. What it draws is given as areas for a display.
class Sheet {
 public:
  // A picture of the given size, or of 16 x 16 pixels where that is smaller.
  Sheet(image::Lettering lettering, int width_px, int height_px);

  // From now on the cells and the places of the pictures are those of the page, which is of this size.
  void Set(Page page);
  const Page& page() const { return page_; }

  // Draws one cell that changed, and gives its area; nothing when all stand as they should. Each has its
  // turn, also where others change all the time.
  std::optional<ports::DisplayArea> DrawNext();

  // Draws the face in its place, in its own proportions, with black beside it. Without pixels: black.
  ports::DisplayArea DrawProgramme(const Pixels& picture);

  // The same of the lip camera's picture, in which the fourth byte is how much a pixel is paint: that is
  // tinted. Without pixels: an empty place.
  ports::DisplayArea DrawLips(const Pixels& picture);

  const image::Picture& picture() const { return picture_; }

 private:
  void Draw(const Cell& cell);
  void Draw(const Piece& piece);
  ports::DisplayArea AreaOf(const Box& box) const;
  void Fill(const Box& box, const image::Colour& colour);
  // Copies the picture into its place. `tints`: paint is tinted.
  ports::DisplayArea Place(const Pixels& picture, const Box& place, const image::Colour& ground, bool tints);

  image::Lettering lettering_;
  image::Picture picture_;
  Page page_;
  // What each cell shows; nothing before it was drawn once.
  std::vector<std::optional<Cell>> stands_;
  // The cell that is looked at first.
  std::size_t next_ = 0;
  // Of Place: where each column comes from; kept for its memory.
  std::vector<std::size_t> columns_;
};

}  // namespace kaori::monitor
