// A MIDI surface, as the HID device that our own dial box is.
#pragma once

#include <array>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/decode/dial_box_reporter.h"
#include "drivers/decode/midi_surface.h"
#include "drivers/ports/hid_channel.h"
#include "drivers/ports/midi_tap.h"

namespace kaori::midi {

// As ports::HidChannel: each message that changes something becomes a report of firmware/wire/dial_box.h, and
// lamps go back as that report says them. One thread.
class MidiChannel final : public ports::HidChannel {
 public:
  // `node` is open and does not block. Sends what the map says to begin with. Borrows the map, the clock and the
  // tap, which hears each message; null: nobody listens.
  MidiChannel(UniqueFd node, const ports::HidIdentity& identity, const decode::MidiMap& map,
              const Clock& clock, ports::MidiTap* tap);

  int pollable() const override { return node_.get(); }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t> into) override;
  Result<void> Write(std::span<const std::uint8_t> report) override;

 private:
  Result<void> Send(std::span<const std::uint8_t> bytes);
  // Lamps that are due again by time.
  void Repaint(Time now);
  Result<void> Fill();
  // Decodes the next byte; whether it changed anything.
  bool AcceptNext();

  UniqueFd node_;
  ports::HidIdentity identity_;
  const decode::MidiMap& map_;
  const Clock& clock_;
  ports::MidiTap* tap_;
  decode::MidiSurface surface_;
  decode::DialBoxReporter reporter_;
  std::array<std::uint8_t, 256> bytes_{};  // As they came, of which those before next_ were decoded.
  std::size_t next_ = 0;
  std::size_t end_ = 0;
  Time read_at_{};
  std::uint32_t lit_ = 0;
  Time painted_at_{};
};

}  // namespace kaori::midi
