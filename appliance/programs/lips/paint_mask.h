// Where a picture is paint: one bit for each sample of a square grid of chroma, freed of single specks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "appliance/programs/lips/paint_key.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// Chroma of 4:2:2 is twice as fine down as across; the grid takes every second row of it.
struct Grid {
  int width = 0;
  int height = 0;
  int row_step = 1;     // Rows of chroma for one of the grid.
  float across_px = 2;  // Pixels of the picture for one sample.
  float down_px = 2;
};

// None (0 x 0) where the planes of colour differ in shape.
Grid GridOf(const decode::Planes& planes);

// Keeps its memory from frame to frame.
class PaintMask {
 public:
  void Read(const decode::Planes& planes, const PaintKey& key);

  const Grid& grid() const { return grid_; }
  std::size_t runs() const { return runs_; }  // Of samples side by side, in all rows.

  // Bit x % 64 of word x / 64 is the sample at x; bits beyond the grid's width are 0.
  std::span<const std::uint64_t> row(int y) const {
    return std::span(voted_).subspan(static_cast<std::size_t>(y) * words_, words_);
  }

 private:
  void VoteOn(std::size_t rows);

  Grid grid_;
  std::size_t words_ = 0;  // For each row.
  std::size_t runs_ = 0;
  std::vector<std::uint64_t> raw_;
  std::vector<std::uint64_t> voted_;
};

}  // namespace kaori::lips
