// The status picture: lines of text one below the other, each drawn again only when it changed. Row by row,
// since the stage draws it beside the show and has only a small part of a frame's time for it.
#pragma once

#include <optional>
#include <vector>

#include "appliance/programs/status/lines.h"
#include "render/image/png.h"
#include "render/image/text.h"

namespace kaori::status {

// Used by one thread. It remembers what each row shows.
class Sheet {
 public:
  // A picture of the given size, or of 16 x 16 pixels where that is smaller.
  Sheet(image::Lettering lettering, int width_px, int height_px);

  // Rows of the picture, from the bottom.
  struct Rows {
    int first = 0;
    int end = 0;
  };
  // Draws one row of text that changed, so that a caller with little time draws one now and then, and returns
  // its rows of pixels. A line that is too long goes on in the next row of text. A row whose mark changed
  // comes first. Returns nothing when the picture is up to date. Where rows are more than fit, letters become
  // smaller, as long as they can be read, and larger again when there is room: then the picture is blank, all of
  // its rows are returned, and the next calls draw the text. The last row counts those for which there is no room.
  std::optional<Rows> DrawNext(const std::vector<Line>& lines);

  const image::Picture& picture() const { return picture_; }

 private:
  // How rows of text stand in the picture.
  struct Layout {
    int pitch_px = 0;      // From row to row of text.
    int size_px = 0;       // Of its letters.
    int words_px = 0;      // Where the words begin, behind what a line is about.
    std::size_t rows = 0;  // For how many there is room.
  };
  // With at least so many rows, and more where the picture is narrow.
  Layout LayoutOf(int rows) const;
  // The largest letters with which all lines fit, or the smallest that can be read.
  Layout Fitting(const std::vector<Line>& lines) const;
  // The lines as rows of text.
  std::vector<Line> Broken(const std::vector<Line>& lines, const Layout& layout) const;
  // The row to draw next, counted from the top; nothing where all rows stand as they should.
  std::optional<std::size_t> Changed(const std::vector<Line>& rows) const;
  // Draws a row anew, its ground included.
  void DrawRow(int row, const Line& line);
  // The picture's rows that a row of text covers.
  Rows RowsOf(int row) const;

  // Letters as they were drawn once; a sheet owns its own.
  image::Lettering lettering_;
  image::Picture picture_;
  Layout layout_;
  // What each row shows; nothing before it was drawn once.
  std::vector<std::optional<Line>> stands_;
};

// Draws all lines. Errors:
//   not_enough_memory  the letters could not be loaded
Result<image::Picture> DrawAll(const std::vector<Line>& lines, int width_px, int height_px);

}  // namespace kaori::status
