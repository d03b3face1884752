#include "render/gl/damage.h"

#include <algorithm>
#include <cstddef>

namespace kaori::gl {

// The box is cut to the picture; a row that it touches by a pixel counts as touched from its lower edge to its upper.
void Damage::Add(const Box& box) {
  const int from_px = std::max(box.left_px, 0);
  const int to_px = std::min(box.left_px + box.width_px, width_px_);
  if (from_px >= to_px) return;
  for (int row = 0; row < kRows; ++row) {
    if (box.bottom_px >= Edge(row + 1) || box.bottom_px + box.height_px <= Edge(row)) continue;
    Span& span = rows_[static_cast<std::size_t>(row)];
    const bool none = span.from_px >= span.to_px;
    span = {none ? from_px : std::min(span.from_px, from_px), none ? to_px : std::max(span.to_px, to_px)};
  }
}

// Pictures of two sizes have no pixel in common.
void Damage::Add(const Damage& other) {
  if (other.width_px_ != width_px_ || other.height_px_ != height_px_) return AddAll();
  for (const Box& box : other.boxes())
    if (!box.empty()) Add(box);
}

std::array<Box, Damage::kRows> Damage::boxes() const {
  std::array<Box, kRows> boxes{};
  for (int row = 0; row < kRows; ++row) {
    const Span& span = rows_[static_cast<std::size_t>(row)];
    boxes[static_cast<std::size_t>(row)] = {span.from_px, Edge(row), span.to_px - span.from_px,
                                            Edge(row + 1) - Edge(row)};
  }
  return boxes;
}

}  // namespace kaori::gl
