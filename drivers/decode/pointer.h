// A mouse or a tablet: reports to a place on the picture, buttons and a wheel.
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

struct PointerSample {
  Time at{};               // When the newest good report arrived.
  float x = 0.5F;          // 0 the left edge of the picture .. 1 the right one.
  float y = 0.5F;          // 0 the upper edge .. 1 the lower one.
  std::int32_t wheel = 0;  // Notches, accumulated; away from the hand is positive; wraps at 32 bits.
  Switches<1> buttons;     // 0 the left one, 1 the right, 2 the middle.
};

// A mouse only says how far it went: so many of its counts lead from edge to edge. A tablet knows its place.
struct PointerSettings {
  float counts_across = 1600;
  float counts_down = 900;
};

// Pure: no descriptor, no clock. It outlives the device: keep its sample over a re-plug to keep the place.
class PointerDecoder {
 public:
  // Any device that Recognise calls kPointer. `before` is where the place and the wheel go on from. Errors:
  // invalid_argument (the descriptor), not_supported (no mouse, no tablet).
  static Result<PointerDecoder> For(const ports::HidIdentity& identity, const PointerSettings& settings = {},
                                    const PointerSample& before = {});

  // Takes one input report. Errors: bad_message  torn, short, long or unknown; the sample stays as it was.
  Result<PointerSample> Decode(std::span<const std::uint8_t> report, Time at);

  // The cable was pulled: buttons go up, the place stays.
  void Release();

  const PointerSample& sample() const { return sample_; }

 private:
  PointerDecoder(ReportLayout layout, const PointerSettings& settings, const PointerSample& before);
  float Moved(const InputReport& report, std::span<const ElementRef> axis, float from, float counts) const;

  ReportLayout layout_;
  PointerSettings settings_;
  std::vector<ElementRef> x_, y_, wheel_;  // A device may speak of an axis in several reports.
  SwitchReader<1> buttons_;
  PointerSample sample_;
};

}  // namespace kaori::decode
