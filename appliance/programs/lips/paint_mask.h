// The mask of the paint in a picture: one bit for each sample of a square grid of chroma, without single
// specks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "appliance/programs/lips/paint_key.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// The grid of samples. Chroma of 4:2:2 is twice as fine vertically as horizontally, so that the grid has
// every second row of it.
struct Grid {
  int width = 0;
  int height = 0;
  int row_step = 1;     // Rows of chroma for one row of the grid.
  float across_px = 2;  // Pixels of the picture for one sample, horizontally
  float down_px = 2;    // and vertically.
};

// The grid of a picture; 0 x 0 where its two planes of chroma differ in size or layout.
Grid GridOf(const decode::Planes& planes);

// Keeps its buffers from frame to frame. Used by one thread. Deterministic, and the same on every processor.
class PaintMask {
 public:
  // Keys a picture. The planes are borrowed for the call. Allocates only for a picture that is larger than
  // those before it. A picture without usable chroma gives an empty grid.
  void Read(const decode::Planes& planes, const PaintKey& key);

  // The grid of the picture that was read last.
  const Grid& grid() const { return grid_; }
  std::size_t runs() const { return runs_; }  // How many runs of paint all rows have together.

  // A row of the mask: bit x % 64 of word x / 64 is the sample at x; bits beyond the grid's width are 0.
  std::span<const std::uint64_t> row(int y) const {
    return std::span(voted_).subspan(static_cast<std::size_t>(y) * words_, words_);
  }

 private:
  // Drops specks and fills pinholes: each sample follows the majority of itself and its four neighbours.
  void VoteOn(std::size_t rows);

  Grid grid_;
  std::size_t words_ = 0;  // For each row.
  std::size_t runs_ = 0;
  // Bits as they were keyed, with an empty row above and below, and as they were voted.
  std::vector<std::uint64_t> raw_;
  std::vector<std::uint64_t> voted_;
};

}  // namespace kaori::lips
