// A screen beside the show's screens that tells technicians how the box does. It may be slow or missing; the
// show does not depend on it.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"

namespace kaori::ports {

// No call blocks. One thread, that of the screen that owns the display.
class StatusDisplay {
 public:
  virtual ~StatusDisplay() = default;

  // The size of its picture; does not change.
  virtual int width_px() const = 0;
  virtual int height_px() const = 0;

  // True until the first Show that succeeded. Then the whole picture must be given, not changed rows alone.
  virtual bool fresh() const = 0;

  // Copies the rows from `first` up to, but without, `end` out of `rgbx`, and shows them. `rgbx` is a whole
  // picture in the layout of PixelMemory; it is not used after the call. Row 0 is the bottom row. Errors:
  //   device_or_resource_busy  the rows are copied, but an earlier Show is still pending; call Show again
  //                            with any rows, or with none, to show them
  //   invalid_argument         `rgbx` has another size, or the rows are outside of the picture
  //   any other                the card cannot show it at all
  virtual Result<void> Show(std::span<const std::uint8_t> rgbx, int first, int end) = 0;
};

}  // namespace kaori::ports
