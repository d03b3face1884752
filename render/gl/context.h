// A GLES 3 context that needs no screen: EGL on Mesa's surfaceless platform.
#pragma once

#include <memory>
#include <string>

#include "drivers/base/result.h"

namespace kaori::gl {

// Current on the thread that opened it; every object of this folder is made, used and dropped there,
// before the context goes.
class Context {
 public:
  // Errors: no_such_device  EGL has no surfaceless platform or no GLES 3
  //         protocol_error  EGL refused to make or use the context
  static Result<std::unique_ptr<Context>> Open();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // The driver's own words: "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& renderer() const { return renderer_; }

  // Shaders may read single samples (GLES 3.1); else these are resolved first. Of the current context.
  static bool ReadsSamples();

 private:
  struct Egl;
  explicit Context(std::unique_ptr<Egl> egl);

  std::unique_ptr<Egl> egl_;
  std::string renderer_;
};

}  // namespace kaori::gl
