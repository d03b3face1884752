// A GLES 3 context: EGL without a screen, or on a graphics card.
//
// All calls of this folder are those of GLES 3.0 unless they say otherwise. An object belongs to the context
// that was current when it was made. Functions bind what they need and leave it bound.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "drivers/base/result.h"

namespace kaori::gl {

// Current on the thread that opened it; every object of this folder is made, used and dropped there, before
// the context goes. In a build for debugging the driver's remarks go to the log, as warnings.
class Context {
 public:
  // On the card of `gbm`, a gbm_device that outlives the context; without one, on no screen at all (the
  // extension EGL_MESA_platform_surfaceless, else EGL_EXT_platform_device). Blocks while the driver loads: some
  // 100 ms. Errors:
  //   no_such_device  EGL has no such platform or no GLES 3
  //   protocol_error  EGL refused to make or use the context
  static Result<std::unique_ptr<Context>> Open(void* gbm = nullptr);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // The driver's name for itself: "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& renderer() const { return renderer_; }

  // EGL's own handles, for windows.
  void* display() const;
  void* config() const;
  void* handle() const;

  // Shaders may read single samples, four of a pixel (GLES 3.1 promises one); else these are resolved first. Of the
  // current context.
  static bool ReadsSamples();
  // Whether the driver of the current context offers an extension, by its whole name.
  static bool Offers(std::string_view extension);

 private:
  // Display, config and context; their types stay out of this header.
  struct Egl;
  explicit Context(std::unique_ptr<Egl> egl);

  // Given back in its destructor, in reverse order.
  std::unique_ptr<Egl> egl_;
  std::string renderer_;
};

}  // namespace kaori::gl
