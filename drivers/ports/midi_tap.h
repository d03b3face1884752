// What MIDI devices sent, as it came, for whoever wants to see it: what is played goes as reports (hid_channel.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "drivers/base/clock.h"

namespace kaori::ports {

// A message of a channel, cut out of the stream (decode/midi.h). Messages of the system and the clock are none.
struct MidiHeard {
  Time at{};                              // When its last byte was read, on CLOCK_MONOTONIC.
  std::uint16_t vendor = 0, product = 0;  // Of the USB device.
  // The status byte with its channel, 80 to EF; the control, note or program; and what it is set to, 0 where the
  // message has one byte of data alone. The last two have seven bits.
  std::uint8_t status = 0, number = 0, value = 0;
  // The dial or the button of the device for which it was meant; neither: for nothing.
  std::optional<std::size_t> dial{}, button{};
};

// The last messages of all devices, for people who look: none of them is played from here, and what came too fast to
// be seen is forgotten. Owned by the program; buses borrow it. One thread, that of the buses; allocates nothing.
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
