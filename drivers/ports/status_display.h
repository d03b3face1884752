// A sign: a screen that says how the box does, for whoever looks after it. It stands beside the show's
// screens and may be slow, or missing.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"

namespace kaori::ports {

// One thread. No call waits.
class StatusDisplay {
 public:
  virtual ~StatusDisplay() = default;

  virtual int width_px() const = 0;
  virtual int height_px() const = 0;
  // Nothing was shown on it yet.
  virtual bool fresh() const = 0;

  // Takes the rows from `first` up to `end` of `rgbx`, which is a whole picture in the layout of PixelBuffer,
  // and shows them. Errors:
  //   device_or_resource_busy  the rows are taken, and what was shown before is still on its way: show again,
  //   of any
  //                            rows or none
  //   and what the screen says that cannot show it at all
  virtual Result<void> Show(std::span<const std::uint8_t> rgbx, int first, int end) = 0;
};

}  // namespace kaori::ports
