#include "render/gl/window.h"

#include <EGL/egl.h>
// After it.
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace kaori::gl {

// The surface is not made current here: the first Begin does so.
Result<Window> Window::Make(const Context& context, void* native) {
  Window window;
  window.display_ = context.display();
  window.context_ = context.handle();
  window.native_ = native;
  const EGLSurface surface = eglCreateWindowSurface(context.display(), context.config(),
                                                    reinterpret_cast<EGLNativeWindowType>(native), nullptr);
  if (surface == EGL_NO_SURFACE) return Fail(std::errc::protocol_error, "make a window of the screen");
  window.surface_ = surface;
  // Names are separated by spaces, and none begins with this one.
  const char* offered = eglQueryString(context.display(), EGL_EXTENSIONS);
  window.tells_age_ =
      offered != nullptr && std::string_view(offered).find("EGL_EXT_buffer_age") != std::string_view::npos;
  return window;
}

Window::~Window() {
  if (surface_ == nullptr) return;
  // A surface that is current is destroyed only when it is no longer so; the context stays current without
  // one.
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  eglDestroySurface(display_, surface_);
}

Window::Window(Window&& other) noexcept {
  *this = std::move(other);
}

// Swaps: what this one had is destroyed with `other`.
Window& Window::operator=(Window&& other) noexcept {
  std::swap(display_, other.display_);
  std::swap(context_, other.context_);
  std::swap(surface_, other.surface_);
  std::swap(native_, other.native_);
  std::swap(tells_age_, other.tells_age_);
  return *this;
}

// The context is made current with the surface each time: other windows may have been drawn to since.
Result<void> Window::Begin(int width_px, int height_px) const {
  if (!eglMakeCurrent(display_, surface_, surface_, context_))
    return Fail(std::errc::protocol_error, "draw into the screen's window");
  // Framebuffer 0 is the surface that is current.
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, width_px, height_px);
  return {};
}

// EGL chooses the buffer now, if it has not done so yet.
int Window::PicturesAgo() const {
  EGLint age = 0;
  if (!tells_age_ || !eglQuerySurface(display_, surface_, EGL_BUFFER_AGE_EXT, &age)) return 0;
  return std::max(age, 0);
}

Result<void> Window::Show() const {
  // A software renderer gives the kernel no fence to wait for: the screen would show a picture in work.
  glFinish();
  if (!eglSwapBuffers(display_, surface_))
    return Fail(std::errc::protocol_error, "give the window's picture to the screen");
  return {};
}

}  // namespace kaori::gl
