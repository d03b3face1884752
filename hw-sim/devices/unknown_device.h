// A simulated USB device that offers interfaces by its descriptors and does nothing: what somebody plugs in
// whom nobody knows.
#pragma once

#include <vector>

#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// Standard requests alone are answered; its endpoints never say anything. One thread.
class UnknownDevice final : public UsbDevice {
 public:
  // Who it says it is, and one interface for each of `interfaces`, which are numbered anew in that order. Each has one bulk
  // endpoint: what needs none is of no use as storage or network.
  UnknownDevice(std::uint16_t vendor, std::uint16_t product, std::vector<UsbInterface> interfaces);
  // Whose configuration descriptor, with all that it holds, is these bytes, as of misleading_descriptors.h.
  UnknownDevice(std::uint16_t vendor, std::uint16_t product, UsbBytes configuration);

  const UsbDescriptors& descriptors() const override { return descriptors_; }
  std::optional<UsbBytes> Answer(const UsbSetup&, std::span<const std::uint8_t>) override {
    return std::nullopt;
  }
  void HandleOut(std::uint8_t, std::span<const std::uint8_t>) override {}
  std::optional<UsbBytes> NextIn(std::uint8_t, std::size_t, Time) override { return std::nullopt; }
  std::optional<Time> next_due(Time) const override { return std::nullopt; }
  void HostCame(std::uint8_t) override {}
  void HostLeft(std::uint8_t) override {}
  void PowerCycle() override {}

 private:
  UsbDescriptors descriptors_;
};

}  // namespace kaori::sim
