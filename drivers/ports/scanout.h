// A screen: memory for the next picture, a flip at its vertical blank, and the time at which it was shown.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/ports/status_display.h"

namespace kaori::ports {

// Memory of 8-bit R, G, B, X in memory order, sRGB; row 0 is the bottom row (as GLES reads pixels). Or a
// window, which EGL draws into by itself; then there is no memory.
struct PixelBuffer {
  int width_px = 0;
  int height_px = 0;
  std::span<std::uint8_t> bytes;  // width * height * 4, tightly packed; or none.
  void* window = nullptr;  // EGL's native window, of the display on which the screen was opened; or none.
};

struct Flip {
  Time at{};                // The vertical blank at which the frame came to light.
  std::uint64_t frame = 0;  // The number given to Present.
  Duration period{};        // To the next vertical blank.
};

// No call blocks. One thread.
class Scanout {
 public:
  virtual ~Scanout() = default;

  // Readable when ReadFlip would give a flip, or the screen is gone.
  virtual int pollable() const = 0;

  // The buffer to draw the next frame into; valid until Present. Its size may change between frames. Errors:
  //   resource_unavailable_try_again  the previous frame waits for its flip
  //   no_such_device                  the screen was unplugged
  virtual Result<PixelBuffer> Acquire() = 0;

  // Shows the acquired buffer at the next vertical blank. Errors: no_such_device,
  //   invalid_argument  nothing was acquired
  virtual Result<void> Present(std::uint64_t frame) = 0;

  // Errors: resource_unavailable_try_again, no_such_device.
  virtual Result<Flip> ReadFlip() = 0;

  // The sign beside this screen, for as long as this lives; or none.
  virtual StatusDisplay* status_display() { return nullptr; }
  // What it is made of, for people, one part a line.
  virtual std::string Words() const { return {}; }
};

}  // namespace kaori::ports
