// Boxes of a picture's layout, cut from each other as paper is.
#pragma once

#include <algorithm>

namespace kaori::monitor {

// Pixels from the left top corner of the picture.
struct Box {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;

  int right() const { return left + width; }
  int bottom() const { return top + height; }
  friend bool operator==(const Box&, const Box&) = default;
};

// Cuts a strip of so many pixels off a side of `from`, or all of it where it has no more, and gives the strip.
inline Box CutTop(Box& from, int height) {
  const Box cut{from.left, from.top, from.width, std::clamp(height, 0, std::max(0, from.height))};
  from = {from.left, cut.bottom(), from.width, from.height - cut.height};
  return cut;
}
inline Box CutBottom(Box& from, int height) {
  const int kept = std::max(0, from.height - std::max(0, height));
  const Box cut{from.left, from.top + kept, from.width, from.height - kept};
  from.height = kept;
  return cut;
}
inline Box CutLeft(Box& from, int width) {
  const Box cut{from.left, from.top, std::clamp(width, 0, std::max(0, from.width)), from.height};
  from = {cut.right(), from.top, from.width - cut.width, from.height};
  return cut;
}
inline Box CutRight(Box& from, int width) {
  const int kept = std::max(0, from.width - std::max(0, width));
  const Box cut{from.left + kept, from.top, from.width - kept, from.height};
  from.width = kept;
  return cut;
}

// So many pixels smaller at each side.
inline Box Inset(const Box& box, int by) {
  return {box.left + by, box.top + by, std::max(0, box.width - 2 * by), std::max(0, box.height - 2 * by)};
}

// The largest box of these proportions within `box`, in its middle. Empty where either has no size.
inline Box Fitted(const Box& box, int width, int height) {
  if (width <= 0 || height <= 0) return {box.left, box.top, 0, 0};
  const int fitted_width =
      std::min(box.width, static_cast<int>(static_cast<long>(box.height) * width / height));
  const int fitted_height =
      std::min(box.height, static_cast<int>(static_cast<long>(fitted_width) * height / width));
  return {box.left + (box.width - fitted_width) / 2, box.top + (box.height - fitted_height) / 2, fitted_width,
          fitted_height};
}

}  // namespace kaori::monitor
