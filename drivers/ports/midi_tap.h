// What MIDI devices sent, as it came, for whoever wants to see it: what is played goes as reports (hid_channel.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "drivers/base/clock.h"

namespace kaori::ports {

// A message of a channel.
struct MidiHeard {
  Time at{};
  std::uint16_t vendor = 0, product = 0;  // Of the USB device.
  std::uint8_t status = 0, number = 0, value = 0;
  std::optional<std::size_t> dial{},
      button{};  // Of the device, for which it was meant; neither: for nothing.
};

// The last messages of all devices. One thread; allocates nothing.
class MidiTap {
 public:
  static constexpr std::size_t kKept = 16;  // A power of two, so that the count may wrap.

  void Note(const MidiHeard& heard) { newest_[count_++ % kKept] = heard; }
  // How many were heard; the message n, counted from 0, is there until kKept more have come.
  std::uint32_t count() const { return count_; }
  const MidiHeard& message(std::uint32_t n) const { return newest_[n % kKept]; }

 private:
  std::uint32_t count_ = 0;
  std::array<MidiHeard, kKept> newest_{};
};

}  // namespace kaori::ports
