// What a USB device asks of the controller that carries its packets.
#pragma once

#include <cstdint>
#include <span>

namespace kaori::surface {

// Endpoint 0 both ways, and one interrupt endpoint each way, 64 bytes a packet. None of the calls waits. One
// side.
class UsbPort {
 public:
  // Endpoint 0. The first packet each way after a SETUP is DATA1, and they alternate from there (USB 2.0,
  // 8.6.1). Takes back what was armed both ways for the transfer before: a SETUP may come in the middle of
  // one.
  virtual void CancelControl() = 0;
  // Arms a packet for the host to fetch; an empty one is a whole transfer's status.
  virtual void SendControl(std::span<const std::uint8_t> packet) = 0;
  // Arms the buffer for a packet of the host, of 64 bytes at most.
  virtual void ReceiveControl() = 0;
  // Answers both ways with STALL until the next SETUP.
  virtual void StallControl() = 0;

  virtual void SetAddress(std::uint8_t address) = 0;

  // The interrupt endpoints begin with DATA0, unhalted, the OUT one armed; or they answer nothing.
  virtual void OpenEndpoints() = 0;
  virtual void CloseEndpoints() = 0;
  // `endpoint` is 0x81 or 0x01. Whoever ends a halt begins with DATA0 again.
  virtual void SetHalt(std::uint8_t endpoint, bool halted) = 0;
  // Whether the host has fetched the report before.
  virtual bool IsInputFree() const = 0;
  // Arms a report.
  virtual void SendInput(std::span<const std::uint8_t> report) = 0;

 protected:
  // Nobody owns one by this type.
  ~UsbPort() = default;
};

}  // namespace kaori::surface
