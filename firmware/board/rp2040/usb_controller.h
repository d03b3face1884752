// The RP2040's USB device controller: packets of the control and interrupt endpoints, asked for and never
// waited for.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/surface/usb_device.h"
#include "firmware/surface/usb_port.h"

namespace kaori::rp2040 {

// Its clock runs. One side.
class UsbController final : public surface::UsbPort {
 public:
  // Shows the device to the host.
  void Start();
  // Tells the device what happened since the last call. To be called often.
  void Service(surface::UsbDevice& device);

  void CancelControl() override;
  void SendControl(std::span<const std::uint8_t> packet) override;
  void ReceiveControl() override;
  void StallControl() override;
  void SetAddress(std::uint8_t address) override;
  void OpenEndpoints() override;
  void CloseEndpoints() override;
  void SetHalt(std::uint8_t endpoint, bool halted) override;
  bool IsInputFree() const override { return input_free_; }
  void SendInput(std::span<const std::uint8_t> report) override;

 private:
  void ServiceBuffers(surface::UsbDevice& device);
  void ArmOutput();

  // Whether the next packet is DATA1, of endpoint 0 and of endpoint 1, each way.
  bool control_in_odd_ = true, control_out_odd_ = true;
  bool input_odd_ = false, output_odd_ = false;
  bool input_free_ = true;
};

}  // namespace kaori::rp2040
