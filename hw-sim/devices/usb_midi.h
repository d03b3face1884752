// A simulated MIDI surface as a USB device, which Linux drives by itself (snd-usb-audio).
#pragma once

#include "hw-sim/devices/midi_twin.h"
#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// By the class definition for MIDI devices, release 1.0: an audio control interface that controls nothing, and a
// streaming interface with a bulk endpoint each way, whose packets hold one message in four bytes. Full speed.
// One thread.
class UsbMidi final : public UsbDevice {
 public:
  // Addresses of the endpoints; bit 7 is towards the host.
  static constexpr std::uint8_t kIn = 0x81;
  static constexpr std::uint8_t kOut = 0x01;

  // Borrows the surface, and is called as it is.
  explicit UsbMidi(MidiTwin& surface);

  const UsbDescriptors& descriptors() const override { return descriptors_; }
  std::optional<UsbBytes> Answer(const UsbSetup&, std::span<const std::uint8_t>) override {
    return std::nullopt;
  }
  void HandleOut(std::uint8_t endpoint, std::span<const std::uint8_t> data) override;
  std::optional<UsbBytes> NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) override;
  std::optional<Time> next_due(Time now) const override;
  void HostCame(std::uint8_t) override {}
  void HostLeft(std::uint8_t) override {}
  void PowerCycle() override;

 private:
  // Packets of what the surface said. A message that is not whole waits for its rest.
  void Pack(std::span<const std::uint8_t> bytes);

  MidiTwin& surface_;
  UsbDescriptors descriptors_;
  UsbBytes packets_;  // That no host has taken.
  UsbBytes message_;  // The beginning of one: status and what has come of its data.
};

}  // namespace kaori::sim
