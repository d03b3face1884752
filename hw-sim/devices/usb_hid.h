// A simulated HID device as a USB device: one interface, with an interrupt endpoint each way where it has
// both.
#pragma once

#include "hw-sim/devices/hid_device.h"
#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// What of a report descriptor matters to the cable. Reads items only as far as that (HID 1.11,
// 6.2.2.2), since these are descriptors of our own.
struct HidShape {
  bool takes_output = false;     // It has output reports.
  bool numbers_reports = false;  // Its reports begin with their number.
  bool is_keyboard = false;      // That is what it says first.
};
// Pure.
HidShape ShapeOf(std::span<const std::uint8_t> report_descriptor);

// Has the device's reports go over USB: interrupt transfers one way,
// SET_REPORT or an OUT endpoint the other.
// What is not at rest when a host comes is told once; Linux throws that away, as all that comes in the
// first 50 ms after a device is opened. How it stands is said whenever a host asks. High speed and
// polled in every microframe: at full speed a host falls behind a device that sends each millisecond
// (device class definition for HID 1.11). One thread.
class UsbHid final : public UsbDevice {
 public:
  // Addresses of the endpoints; bit 7 is towards the host.
  static constexpr std::uint8_t kIn = 0x81;
  static constexpr std::uint8_t kOut = 0x01;

  // Borrows the device. The descriptors are made once: a device does not change its kind.
  explicit UsbHid(HidDevice& device);

  const UsbDescriptors& descriptors() const override { return descriptors_; }
  std::optional<UsbBytes> Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) override;
  void HandleOut(std::uint8_t endpoint, std::span<const std::uint8_t> data) override;
  std::optional<UsbBytes> NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) override;
  std::optional<Time> next_due(Time now) const override;
  void HostCame(std::uint8_t) override;
  void HostLeft(std::uint8_t) override;
  void PowerCycle() override { device_.PowerCycle(); }

 private:
  // HID's own descriptors, which are asked for at the interface (HID 1.11, 7.1.1).
  std::optional<UsbBytes> Descriptor(std::uint8_t kind) const;

  // What it carries to the host; borrowed.
  HidDevice& device_;
  bool host_is_new_ = false;  // It came since NextIn was last called, and something is not at rest.
  // Of the device's own report descriptor.
  HidShape shape_;
  // Made of the device's own name and report descriptor.
  UsbDescriptors descriptors_;
};

}  // namespace kaori::sim
