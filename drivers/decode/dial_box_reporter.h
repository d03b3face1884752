// Says the counts and buttons of another device as reports of our own dial box.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "drivers/decode/dial_box.h"

namespace kaori::decode {

// For drivers of devices that are no HID devices, and stand on the board as our dial box does: serial boxes,
// MIDI surfaces, encoders on GPIO lines. The descriptor that goes with it is wire::kDialBoxDescriptor. Pure;
// one thread.
class DialBoxReporter {
 public:
  // What was counted before is told as said already.
  explicit DialBoxReporter(const std::array<std::int32_t, kMaxDials>& told = {}) : told_(told) {}

  // Puts a report of what changed into `into`, cut off where it does not fit, and returns its length. A turn
  // beyond what a report can say is said by the next one; there is one while has_rest.
  std::size_t Report(const std::array<std::int32_t, kMaxDials>& counts, std::uint32_t buttons_down,
                     std::span<std::uint8_t> into);
  bool has_rest() const { return has_rest_; }

 private:
  std::array<std::int32_t, kMaxDials> told_;
  bool has_rest_ = false;
};

}  // namespace kaori::decode
