// A screen beside the show's screens: tells technicians how the box does, or operators how the show stands.
// It may be slow or missing; the show does not depend on it.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"

namespace kaori::ports {

// Pixels of a picture whose row 0 is the bottom row; right and top are exclusive.
struct DisplayArea {
  int left_px = 0;
  int bottom_px = 0;
  int right_px = 0;
  int top_px = 0;
  friend bool operator==(const DisplayArea&, const DisplayArea&) = default;
};

// Whether an area is one, and lies in a picture of this size. Pure.
constexpr bool IsWithin(const DisplayArea& area, int width_px, int height_px) {
  return 0 <= area.left_px && area.left_px <= area.right_px && area.right_px <= width_px &&
         0 <= area.bottom_px && area.bottom_px <= area.top_px && area.top_px <= height_px;
}

// Belongs to the screen beside which it stands, and ends with it. No call blocks. One thread, that of the screen.
class SideDisplay {
 public:
  virtual ~SideDisplay() = default;

  // The size of its picture; does not change.
  virtual int width_px() const = 0;
  virtual int height_px() const = 0;

  // True until the first Show that succeeded. Then the whole picture must be given, not changed areas alone.
  virtual bool fresh() const = 0;

  // Copies the areas out of `rgbx`, and shows them together. `rgbx` is a whole picture in the layout of
  // PixelMemory; it is not used after the call. Errors:
  //   device_or_resource_busy  the areas are copied, but an earlier Show is still pending; call Show again
  //                            with any areas, or with none, to show them
  //   invalid_argument         `rgbx` has another size, or an area is not within the picture
  //   any other                the card cannot show it at all
  virtual Result<void> Show(std::span<const std::uint8_t> rgbx, std::span<const DisplayArea> areas) = 0;
};

}  // namespace kaori::ports
