// Draws a scene of a show into memory: the GL context, the painter and a canvas of the size that is asked
// for.
#pragma once

#include <memory>
#include <string>

#include "appliance/show/show.h"
#include "drivers/base/result.h"
#include "drivers/ports/scanout.h"
#include "render/gl/canvas.h"
#include "render/gl/context.h"
#include "render/passes/painter.h"
#include "render/scene/scene.h"

namespace kaori::stage {

// One thread: the one that opened it.
class Studio {
 public:
  // Blocks while shaders compile and textures load. Errors: those of gl::Context and Painter.
  static Result<std::unique_ptr<Studio>> Open(show::Show show);

  // Draws `scene` into `picture`, whole. Makes a new canvas only when the size changes.
  Result<void> Draw(const scene::Scene& scene, const ports::PixelBuffer& picture);

  // To be called after a frame is out: readies one more of the drawing's shaders, so that no fade waits for it
  // later. Takes 10 to 40 ms while there is any left, then nothing.
  void Prepare() { unprepared_ = unprepared_ && painter_->RehearseStep(); }

  const show::Show& show() const { return show_; }
  const std::string& renderer() const { return context_->renderer(); }

 private:
  Studio(std::unique_ptr<gl::Context> context, show::Show show)
      : context_(std::move(context)), show_(std::move(show)) {}

  std::unique_ptr<gl::Context> context_;  // First in, last out: the rest lives in it.
  show::Show show_;
  std::unique_ptr<passes::Painter> painter_;
  gl::Canvas canvas_;
  bool unprepared_ = true;
};

}  // namespace kaori::stage
