// The bytes by which a USB video camera says what it has (USB Video Class 1.1, and its uncompressed payload).
#pragma once

#include <cstdint>

#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// One camera: a size, a rate, YUYV. The period is in units of 100 ns, as UVC counts.
struct UvcMode {
  // Of the one frame size.
  std::uint16_t width_px = 640;
  std::uint16_t height_px = 480;
  // From frame to frame: 30 frames/s.
  std::uint32_t period_100ns = 333333;
  std::uint32_t payload_bytes = 65536;  // Of the longest payload.
  // Bit 7: towards the host.
  std::uint8_t endpoint = 0x81;

  // Two bytes a pixel.
  std::uint32_t frame_bytes() const { return std::uint32_t{width_px} * height_px * 2; }
};

// The whole configuration: a video control interface and a streaming interface, held together by an
// association. The streaming interface has no alternate setting, so that a host streams in bulk. Pure.
UsbBytes UvcConfiguration(const UvcMode& mode);

// What the probe and commit controls hold (UVC 1.1, 4.3.1.1, table 4-47): there is one way to
// stream, so every request gets the same. Pure.
UsbBytes UvcProbe(const UvcMode& mode);

}  // namespace kaori::sim
