#include "render/gl/window.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <array>
#include <utility>

namespace kaori::gl {

Result<Window> Window::Make(const Context& context, void* native) {
  // Coded as the canvas's picture is, so that copying changes no bit.
  constexpr std::array kCoded{EGL_GL_COLORSPACE_KHR, EGL_GL_COLORSPACE_SRGB_KHR, EGL_NONE};
  Window window;
  window.display_ = context.display();
  window.context_ = context.handle();
  window.native_ = native;
  const EGLSurface surface = eglCreateWindowSurface(
      context.display(), context.config(), reinterpret_cast<EGLNativeWindowType>(native), kCoded.data());
  if (surface == EGL_NO_SURFACE) return Fail(std::errc::protocol_error, "make a window of the screen");
  window.surface_ = surface;
  return window;
}

Window::~Window() {
  if (surface_ == nullptr) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  eglDestroySurface(display_, surface_);
}

Window::Window(Window&& other) noexcept {
  *this = std::move(other);
}

Window& Window::operator=(Window&& other) noexcept {
  std::swap(display_, other.display_);
  std::swap(context_, other.context_);
  std::swap(surface_, other.surface_);
  std::swap(native_, other.native_);
  return *this;
}

Result<void> Window::Show(const Canvas& canvas) {
  if (!eglMakeCurrent(display_, surface_, surface_, context_))
    return Fail(std::errc::protocol_error, "draw into the screen's window");
  canvas.CopyTo(0);
  glFinish();
  if (!eglSwapBuffers(display_, surface_))
    return Fail(std::errc::protocol_error, "hand the window to the screen");
  return {};
}

}  // namespace kaori::gl
