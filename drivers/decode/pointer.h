// Decodes a mouse or a tablet: reports to a position on the picture, buttons and a wheel.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/decode/report_values.h"
#include "drivers/decode/switches.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::decode {

// The newest state of a mouse or a tablet, in the frame of the picture.
struct PointerSample {
  Time at{};               // When the newest good report arrived.
  float x = 0.5F;          // 0 the left edge of the picture .. 1 the right one.
  float y = 0.5F;          // 0 the upper edge .. 1 the lower one.
  std::int32_t wheel = 0;  // Notches, accumulated; away from the operator is positive; wraps at 32 bits.
  Switches<1> buttons;     // 0 the left one, 1 the right, 2 the middle.
};

// How many counts of a mouse lead from edge to edge of the picture. A tablet tells its position and
// needs none. The defaults give square pixels at 16 to 9, and an edge within one sweep of the hand.
struct PointerSettings {
  float counts_across = 1600;
  float counts_down = 900;
};

// Pure: no file descriptor, no clock. Keep its sample over a re-plug to keep the
// position. There is no acceleration: the editor's handles are dragged by eye,
// and the same path always leads to the same place.
class PointerDecoder {
 public:
  // For any device that Recognise calls kPointer. Position and wheel go on from
  // those of `before`; its buttons are up. Errors:
  //   invalid_argument  the report descriptor is broken
  //   not_supported     the device is no mouse and no tablet
  static Result<PointerDecoder> For(const ports::HidIdentity& identity, const PointerSettings& settings = {},
                                    const PointerSample& before = {});

  // Decodes one input report and returns the new sample. Errors:
  //   bad_message  the report is torn, short, long or of an unknown id; the sample stays as it was
  Result<PointerSample> Decode(std::span<const std::uint8_t> report, Time at);

  // To be called when the cable was pulled: buttons go up, the position stays.
  void Release();

  // The newest sample, also after Release.
  const PointerSample& sample() const { return sample_; }

 private:
  PointerDecoder(ReportLayout layout, const PointerSettings& settings, const PointerSample& before);
  // The position on one axis, 0 to 1, after `report`, which may not have the axis. `counts` lead from
  // edge to edge. Several fields of one axis are applied in the order of the descriptor.
  float Moved(const InputReport& report, std::span<const ElementRef> axis, float from, float counts) const;

  // Of the device's descriptor.
  ReportLayout layout_;
  PointerSettings settings_;
  // Elements of X, Y and the wheel, in the order of the descriptor.
  std::vector<ElementRef> x_, y_, wheel_;  // A device may have an axis in several reports.
  SwitchReader<1> buttons_;
  PointerSample sample_;
};

}  // namespace kaori::decode
