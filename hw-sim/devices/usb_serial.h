// A simulated FTDI adapter with a serial box of 1993 at its other end, which Linux drives by itself (ftdi_sio).
#pragma once

#include "hw-sim/devices/serial_dial_box.h"
#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// An FT232R: its requests set speed and format of the line, and each packet to the host begins with two bytes
// that say how the line stands. Where the host sets another speed or format than the box has, bytes arrive
// spoilt both ways, as at a pseudo-terminal (hw-sim/links/serial). What comes from the line is collected until it was silent for four
// bytes' time, so that a machine that is emulated, and slow, sees a message in one piece: the real part does so where a host
// sets its latency timer long. Full speed. One thread.
class UsbSerial final : public UsbDevice {
 public:
  // Addresses of the endpoints; bit 7 is towards the host.
  static constexpr std::uint8_t kIn = 0x81;
  static constexpr std::uint8_t kOut = 0x02;

  // Borrows the box, whose power comes by the adapter.
  explicit UsbSerial(SerialDialBox& box);

  // As the host has set it; 0: not yet.
  double baud() const { return baud_; }

  const UsbDescriptors& descriptors() const override { return descriptors_; }
  std::optional<UsbBytes> Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) override;
  void HandleOut(std::uint8_t endpoint, std::span<const std::uint8_t> data) override;
  std::optional<UsbBytes> NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) override;
  std::optional<Time> next_due(Time now) const override;
  void HostCame(std::uint8_t) override {}
  void HostLeft(std::uint8_t) override {}
  void PowerCycle() override;

 private:
  // Whether what came may go to the host.
  bool is_ready(Time now) const;
  bool fits() const;  // The line is set as the box is.

  SerialDialBox& box_;
  UsbDescriptors descriptors_;
  double baud_ = 0;
  bool is_8n1_ = false;
  UsbBytes sent_;   // By the host, until a time is known at which the box gets it.
  UsbBytes come_;   // From the box, until a host takes it.
  Time came_at_{};  // The last byte of it.
};

}  // namespace kaori::sim
