// A window that a screen shows: EGL's surface on a native one, on which finished pictures are drawn.
#pragma once

#include "drivers/base/result.h"
#include "render/gl/context.h"

namespace kaori::gl {

// On the thread of its context, which outlives it, as does the native window. Moves, and does not copy.
class Window {
 public:
  Window() = default;
  // `native` is a gbm_surface of the context's card. Errors: protocol_error (EGL takes no such window).
  static Result<Window> Make(const Context& context, void* native);
  ~Window();
  // The other is left without a surface.
  Window(Window&& other) noexcept;
  Window& operator=(Window&& other) noexcept;

  // The native window that it was made of; null where there is none yet.
  void* native() const { return native_; }

  // Drawing goes to the window from here on, all of it, and writes codes as they are: its format is not sRGB.
  // Turns the scissor test off. Errors: protocol_error.
  Result<void> Begin(int width_px, int height_px) const;

  // Which picture the window's buffer holds that is drawn on now: the one that was shown so many times ago, 1 the
  // last one. 0: none that is known, or the driver does not say (EGL_EXT_buffer_age). Between Begin and Show.
  int PicturesAgo() const;

  // Gives what was drawn to the screen (eglSwapBuffers; the caller then fetches the buffer from GBM). Waits
  // until the renderer has finished. Errors: protocol_error.
  Result<void> Show() const;

 private:
  // EGL's handles and the gbm_surface, as void* so that EGL's headers, which define short names, stay
  // in one file.
  void* display_ = nullptr;
  void* context_ = nullptr;
  void* surface_ = nullptr;
  void* native_ = nullptr;
  // Whether the driver says how old buffers are.
  bool tells_age_ = false;
};

}  // namespace kaori::gl
