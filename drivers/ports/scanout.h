// A screen, or several that show one picture: a buffer for the next frame, a flip at the vertical blank, and
// the time at which the frame was presented.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/ports/output.h"
#include "drivers/ports/side_display.h"

struct gbm_surface;  // Of libgbm; only its address passes through this port.

namespace kaori::ports {

// Memory that the program writes by itself: 8-bit R, G, B, X in this order in memory, sRGB, width_px *
// height_px * 4 bytes without padding. Row 0 is the bottom row, as glReadPixels delivers it.
struct PixelMemory {
  std::span<std::uint8_t> rgbx;
};

// A surface that EGL draws into and swaps. `surface` is the native window of the EGL display that was made
// from the same gbm_device as the screen.
struct EglSurface {
  gbm_surface* surface = nullptr;
};

// Where the next frame is drawn.
struct PixelBuffer {
  // In pixels; the same in every frame until the screen is opened anew.
  int width_px = 0;
  int height_px = 0;
  std::variant<PixelMemory, EglSurface> target;

  // The bytes of a PixelMemory; none where EGL draws.
  std::span<std::uint8_t> memory() const {
    const auto* pixels = std::get_if<PixelMemory>(&target);
    return pixels == nullptr ? std::span<std::uint8_t>() : pixels->rgbx;
  }
};

// A frame that was presented.
struct Flip {
  Time at{};                // The vertical blank at which the screen began to show the frame.
  std::uint64_t frame = 0;  // The number that was given to Present.
  Duration period{};        // From one vertical blank to the next.
};

// One frame goes round at a time: Acquire, draw, Present, ReadFlip. No call blocks. One thread.
class Scanout {
 public:
  // Never blanks the screens where the implementation's header says so.
  virtual ~Scanout() = default;

  // A descriptor that is readable when ReadFlip would give a flip, or when the screen is gone. It belongs to
  // the screen and is valid for as long as the screen.
  virtual int pollable() const = 0;

  // The buffer of the next frame. The screen lends it until Present, or until the screen's own end. A second Acquire
  // before Present lends the same buffer again. What it holds is anything: the whole picture is drawn each time. The
  // size and the target may differ from those of the frame before. Errors:
  //   resource_unavailable_try_again  the frame before has not been presented yet, or a screen that was just
  //                                   opened has not answered yet
  //   no_such_device                  the screen was unplugged, or must be opened anew to be used as it is
  //                                   now; every later call says the same
  virtual Result<PixelBuffer> Acquire() = 0;

  // Shows the acquired buffer at the next vertical blank, and returns before that. `frame` is the caller's
  // number; ReadFlip returns it. Errors:
  //   no_such_device           as Acquire
  //   invalid_argument         no buffer is acquired
  //   device_or_resource_busy  the card has a flip pending; the buffer is given back unseen, acquire anew
  //   any other                the card refuses the picture; open the screen anew
  virtual Result<void> Present(std::uint64_t frame) = 0;

  // The frame that was presented last, once. Errors:
  //   resource_unavailable_try_again  no frame was presented since the last call
  //   no_such_device                  as Acquire
  virtual Result<Flip> ReadFlip() = 0;

  // The displays beside this screen, for technicians and for operators; each may be null. They belong to the
  // screen and end with it.
  virtual SideDisplay* status_display() { return nullptr; }
  virtual SideDisplay* monitor_display() { return nullptr; }

  // What the card drives, in the order of the picture's parts from the left top; displays beside it are last.
  // Empty while the screen has not answered or is gone.
  virtual std::vector<Output> outputs() const { return {}; }
};

}  // namespace kaori::ports
