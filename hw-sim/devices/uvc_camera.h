// The simulated lip camera as a USB video device: uncompressed pictures over a bulk endpoint.
#pragma once

#include <cstddef>

#include "hw-sim/devices/lip_camera.h"
#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// USB Video Class 1.1. One format (YUYV), the size that the camera has when this is made, one rate. A
// frame begins when a host reads and the frame's time has come; frames that nobody read go by, and are
// missing from the numbers of the camera as well. One thread.
class UvcCamera final : public UsbDevice {
 public:
  // The address of its one endpoint.
  static constexpr std::uint8_t kIn = 0x81;
  static constexpr std::size_t kPayloadBytes = 65536;  // Of the longest payload, its header included.

  // Borrows the camera, which delivers YUYV and keeps its size. `period` lies between two frames.
  UvcCamera(LipCamera& camera, Duration period);

  // How many frames were sent or are being sent, for tests.
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
  // Draws the newest frame and cuts it into payloads; false where none is due.
  bool BeginFrame(Time now);
  // The stream starts anew with the next read, and so does the count of its frames.
  void EndStream();

  // Draws the pictures; borrowed.
  LipCamera& camera_;
  // From frame to frame, as the descriptors promise it.
  Duration period_;
  UsbDescriptors descriptors_;
  // One frame, as the camera drew it.
  UsbBytes picture_;
  // The frame that is under way, cut into payloads, each behind its header.
  UsbBytes payloads_;
  std::size_t sent_ = 0;  // How much of it has left.
  // Its last transfer was as long as it could be: an empty one must say that it ends (USB 2.0, 5.8.3).
  bool ends_full_ = false;
  // The frame id bit of the payload headers, which changes with each frame: a host that lost the
  // end of a frame finds the next one by it.
  bool parity_ = false;
  // When the stream began: the time of frame 0. None while nobody reads.
  std::optional<Time> began_;
  std::int64_t last_ = -1;  // The newest frame of this stream.
  std::uint64_t frames_begun_ = 0;
};

}  // namespace kaori::sim
