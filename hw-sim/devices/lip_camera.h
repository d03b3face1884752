// The simulated lip camera: draws the lower half of a face whose lips are painted blue.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "drivers/ports/camera.h"
#include "hw-sim/devices/lip_picture.h"
#include "hw-sim/devices/operator_action.h"

namespace kaori::sim {

// How the next frame is spoilt: not at all, in the numbers that come with it, or in its pixels.
enum class Spoil : std::uint8_t { kNothing, kMessage, kPixels };

// Draws frames on request; when they are taken is the link's business. One thread. The same mouth and
// the same frame numbers give the same bytes, so that a test can compare pictures.
class LipCamera {
 public:
  // Borrows the context.
  LipCamera(ports::CameraFormat format, const DeviceContext& context);

  // Test's side. Sizes are in widths of the mouth at rest, held within 0.02 .. 2 (height) and 0.1 .. 2
  // (width). Numbers that are none leave a size as it is.
  void SetMouth(double height, double width);
  // A covered lens sees nothing but noise.
  void CoverLens(bool covered);
  void Stall(bool stalled);                         // No frames while stalled; their numbers go by.
  void SendGarbage() { spoil_ = Spoil::kMessage; }  // The next frame comes with nonsense for its numbers.
  void Scramble() { spoil_ = Spoil::kPixels; }      // The next frame's bytes are noise.
  void SetFormat(ports::CameraFormat format);       // Even sizes up to 1920 x 1080; others are ignored.
  // As it is held within its range.
  Mouth mouth() const { return mouth_; }
  bool covered() const { return covered_; }
  bool stalled() const { return stalled_; }
  ports::CameraFormat format() const { return format_; }

  // Appliance's side. Bytes that every frame of the present format fits into; JPEG is given as many as YUYV.
  std::size_t frame_bytes() const;
  // Of a row of Y, or of YUYV; 0 for MJPEG.
  std::uint32_t stride_bytes() const;

  // Draws frame `sequence` into `into` (frame_bytes of room); the same numbers give the same bytes.
  // Blocks while it draws. Returns the bytes used; 0 where `into` is too small.
  std::size_t Shoot(std::uint32_t sequence, std::span<std::uint8_t> into);

  // How the frame that is now leaving is spoilt; the one after it is clean again.
  Spoil ExchangeSpoil() { return std::exchange(spoil_, Spoil::kNothing); }

 private:
  // Draws the picture as YUYV, with noise.
  void Draw(std::uint32_t sequence, std::span<std::uint8_t> yuyv);

  const DeviceContext& context_;
  ports::CameraFormat format_{};
  Mouth mouth_;
  bool covered_ = false;
  bool stalled_ = false;
  // Of the next frame alone.
  Spoil spoil_ = Spoil::kNothing;
  std::vector<std::uint8_t> backdrop_;  // YUYV: the face without its mouth; painted for the first frame.
  std::vector<std::uint8_t> picture_;   // YUYV: where other formats are made from.
};

}  // namespace kaori::sim
