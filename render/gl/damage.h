// Which part of a picture was drawn on: the field's word for what a copy of it lacks.
#pragma once

#include <array>

#include "render/gl/box.h"

namespace kaori::gl {

// Rows across a picture; in each, all from the leftmost to the rightmost pixel that was drawn on. No more than
// this is kept, so that adding costs little and allocates nothing. On any thread, one at a time.
class Damage {
 public:
  static constexpr int kRows = 20;

  // Nothing, of a picture without pixels: all that is added to it is lost.
  Damage() = default;
  // Nothing yet, of a picture of this size.
  Damage(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}

  // What of `box` lies within the picture.
  void Add(const Box& box);
  // What another picture of the same size lacks; of another size: all.
  void Add(const Damage& other);
  // The picture, whole.
  void AddAll() { Add(Box{0, 0, width_px_, height_px_}); }

  // By rows from below; empty where nothing was drawn. Together the rows are as high as the picture.
  std::array<Box, kRows> boxes() const;

 private:
  // Columns [from_px, to_px); none where from_px is not below.
  struct Span {
    int from_px = 0;
    int to_px = 0;
  };
  // The lower edge of a row; the upper one of the row below it.
  int Edge(int row) const { return static_cast<int>(static_cast<long long>(height_px_) * row / kRows); }

  int width_px_ = 0;
  int height_px_ = 0;
  std::array<Span, kRows> rows_{};
};

}  // namespace kaori::gl
