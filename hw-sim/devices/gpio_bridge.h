// A simulated CP2112: a USB bridge with eight GPIO lines, which Linux drives by itself (hid-cp2112).
#pragma once

#include <array>

#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// By its data sheet (AN495 of its maker): everything goes by HID feature reports. Its I2C side answers
// nothing. A host looks at the lines every 40 ms: what is shorter, nobody sees, as at the real part,
// whose interrupts Linux emulates by polling. One thread.
class GpioBridge final : public UsbDevice {
 public:
  // Numbered 0 to 7, as the part's pins GPIO.0 to GPIO.7.
  static constexpr int kLines = 8;

  GpioBridge();

  // Test's side. Lines are pulled up; a switch pulls its line to ground. Numbers outside 0..7 are
  // ignored. What is done here takes part at once, and is seen when the host looks next.
  void Close(int line) { Pull(line, true); }  // The switch is pressed.
  void Open(int line) { Pull(line, false); }  // The switch is let go.
  bool drives(int line) const;                // The host has made it an output.
  bool high(int line) const;                  // The level on the line now.

  // Appliance's side: control requests alone. The interrupt endpoints are there, as at the real part,
  // and carry nothing, since they are for I2C.
  const UsbDescriptors& descriptors() const override { return descriptors_; }
  std::optional<UsbBytes> Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) override;
  void HandleOut(std::uint8_t, std::span<const std::uint8_t>) override {}
  std::optional<UsbBytes> NextIn(std::uint8_t, std::size_t, Time) override { return std::nullopt; }
  std::optional<Time> next_due(Time) const override { return std::nullopt; }
  void HostCame(std::uint8_t) override {}
  void HostLeft(std::uint8_t) override {}
  void PowerCycle() override;

 private:
  // Closes the switch of a line, or opens it.
  void Pull(int line, bool down);
  // Bit n: line n is high. What pulls down wins over what is let up.
  std::uint8_t levels() const;
  // The bytes of a feature report, its number first; nothing for one that is
  // not known: the request stalls.
  std::optional<UsbBytes> Feature(std::uint8_t report) const;
  // Takes a feature report in, its number first; false for one that is not known or too short.
  bool SetFeature(std::span<const std::uint8_t> report);

  UsbDescriptors descriptors_;
  std::uint8_t outputs_ = 0;      // Bit n: line n is an output.
  std::uint8_t push_pull_ = 0;    // Bit n: as an output it drives high too; else it only pulls down.
  std::uint8_t driven_ = 0xFF;    // Bit n: the level to which the host drives it.
  std::uint8_t pulled_down_ = 0;  // Bit n: the switch at line n is closed.
};

}  // namespace kaori::sim
