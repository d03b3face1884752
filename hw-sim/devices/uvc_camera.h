// The simulated lip camera as a USB video device: uncompressed pictures over a bulk endpoint.
#pragma once

#include <cstddef>

#include "hw-sim/devices/lip_camera.h"
#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// USB Video Class 1.1. One format (YUYV), the size that the camera has when this is made, one rate. One thread. A frame
// begins when a host reads and the frame's time has come; frames that nobody read go by.
class UvcCamera final : public UsbDevice {
 public:
  static constexpr std::uint8_t kIn = 0x81;
  static constexpr std::size_t kPayloadBytes = 65536;  // Of the longest payload, its header included.

  // Borrows the camera, which delivers YUYV.
  UvcCamera(LipCamera& camera, Duration period);

  std::uint64_t frames_begun() const { return frames_begun_; }

  const UsbDescriptors& descriptors() const override { return descriptors_; }
  std::optional<UsbBytes> Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) override;
  void HandleOut(std::uint8_t, std::span<const std::uint8_t>) override {}
  std::optional<UsbBytes> NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) override;
  std::optional<Time> next_due(Time now) const override;
  void HostCame(std::uint8_t) override {}
  void HostLeft(std::uint8_t) override {}
  void PowerCycle() override { EndStream(); }

 private:
  bool BeginFrame(Time now);
  void EndStream();

  LipCamera& camera_;
  Duration period_;
  UsbDescriptors descriptors_;
  UsbBytes picture_;
  UsbBytes payloads_;     // The frame that is under way, cut into payloads.
  std::size_t sent_ = 0;  // How much of it has left.
  bool ends_full_ =
      false;             // Its last transfer was as long as it could be: an empty one must say that it ends.
  bool parity_ = false;  // Changes with each frame.
  std::optional<Time> began_;
  std::int64_t last_ = -1;  // The newest frame of this stream.
  std::uint64_t frames_begun_ = 0;
};

}  // namespace kaori::sim
