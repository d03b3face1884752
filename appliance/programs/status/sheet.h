// The status picture: lines lettered one below the other, each drawn anew only when it changed.
#pragma once

#include <optional>
#include <vector>

#include "appliance/programs/status/lines.h"
#include "render/image/png.h"
#include "render/image/text.h"

namespace kaori::status {

// One thread.
class Sheet {
 public:
  // 16 x 16 pixels at least; a smaller picture is so large all the same.
  Sheet(image::Lettering lettering, int width_px, int height_px);

  // Rows of the picture, from the bottom.
  struct Rows {
    int first = 0;
    int end = 0;
  };
  // Draws one line that does not yet stand there so: a caller that has little time at once draws one now and
  // then. What changed its mark goes first. Nothing: all of them stand. Lines that do not fit are told by
  // their number.
  std::optional<Rows> DrawNext(const std::vector<Line>& lines);

  const image::Picture& picture() const { return picture_; }

 private:
  std::optional<std::size_t> Changed(const std::vector<Line>& lines) const;
  void DrawRow(int row, const Line& line);
  Rows RowsOf(int row) const;

  image::Lettering lettering_;
  image::Picture picture_;
  int pitch_px_;  // From line to line.
  std::vector<std::optional<Line>> stands_;
};

// All of it at once. Errors: not_enough_memory.
Result<image::Picture> DrawAll(const std::vector<Line>& lines, int width_px, int height_px);

}  // namespace kaori::status
