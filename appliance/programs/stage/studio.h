// Draws scenes of a show: owns the GL context, the painter, and a canvas of the size that is asked for.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "appliance/core/show/show.h"
#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/ports/scanout.h"
#include "render/gl/canvas.h"
#include "render/gl/context.h"
#include "render/gl/readback.h"
#include "render/gl/target.h"
#include "render/gl/window.h"
#include "render/passes/painter.h"
#include "render/passes/preparation.h"
#include "render/passes/screen.h"
#include "render/scene/scene.h"

namespace kaori::stage {

// A copy of what was drawn, for the disk and for pages. R, G, B, X; the top row first.
struct SmallImage {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> pixels;
};

// A show, and what can be worked out of it without a graphics card: on any thread. It stays where it is. It
// is made beside the opening of the GL context, which takes about as long.
class PreparedShow {
 public:
  explicit PreparedShow(show::Show show)
      : show_(std::move(show)),
        preparation_(show_.cast, show_.scenes.empty() ? 0 : show_.scenes.front().face) {}
  PreparedShow(const PreparedShow&) = delete;
  PreparedShow& operator=(const PreparedShow&) = delete;

  const show::Show& show() const { return show_; }

 private:
  friend class Studio;
  show::Show show_;
  passes::Preparation preparation_;  // Goes into a studio's painter.
};

// One thread: the one that opened it, since a GL context belongs to one. It owns the show from then on.
class Studio {
 public:
  // Blocks while shaders compile and textures load. `gbm` as gl::Context says. Errors: those of gl::Context
  // and Painter.
  static Result<std::unique_ptr<Studio>> Open(show::Show show, void* gbm = nullptr);
  // The same in a context of the caller's, which is current on this thread. Errors: those of Painter.
  static Result<std::unique_ptr<Studio>> Open(std::unique_ptr<PreparedShow> prepared,
                                              std::unique_ptr<gl::Context> context);

  // For a simulator that plays hours in minutes: of so many pictures one is drawn, the first one of them, and
  // the others keep what they hold. 1 or more.
  void DrawOneOf(int pictures) { one_of_ = static_cast<std::uint64_t>(pictures); }
  // Whether the last Draw drew.
  bool drew() const { return drew_; }

  // Draws `scene` into `picture`, whole: into its memory or its window. Makes a new canvas only when the size
  // changes. Blocks until the processor has its pixels, or the graphics card its commands. Errors: those of
  // gl::Canvas::Make, gl::Window and ScreenPass::Open.
  Result<void> Draw(const scene::Scene& scene, const ports::PixelBuffer& picture);

  // The cast's expression of this index is from now on what these say; the next frame shows it.
  // `displacement` has one for each control point, and `lids` are within 0..1. Takes 30 us for each face that
  // has weight. To be called between frames. `expression` is below the cast's count; displacements are in
  // metres along u, v and outwards.
  void Renew(std::uint16_t expression, std::span<const glm::vec3> displacement,
             const std::array<float, 2>& lids);

  // The face as it was drawn last; holds until the next Draw or Prepare.
  const face::Shape& shape() const { return painter_->shape(); }

  // What was drawn last, of at most `most_width_px`, copied out; waits until it is finished. R, G, B, X; the
  // top row first. False where nothing was drawn.
  bool ReadSmall(int most_width_px, SmallImage& into);

  // Begins to copy what was drawn last, in the canvas's proportions within this size and no larger than it, and
  // returns at once. Nothing where nothing was drawn, or a copy is on its way.
  void AskPicture(int most_width_px, int most_height_px);
  // The copy that was asked for, as ReadSmall gives it; false: it is not there yet. Waits for nothing. It is
  // of the time of AskPicture.
  bool FetchPicture(SmallImage& into);

  // To be called after a frame is out: readies one more of the drawing's shaders, so that no fade waits for
  // it later. Takes 10 to 40 ms while there is any left, then nothing. True once: when it was the last.
  bool Prepare() { return unprepared_ && !(unprepared_ = painter_->WarmUpStep()); }

  // How finely it draws, which is basic until another quality is set. Errors: as Painter::SetQuality.
  passes::Quality quality() const { return painter_->quality(); }
  Result<void> SetQuality(passes::Quality quality);
  // Draws a frame of this size that nobody sees, and waits until it is finished. Errors: those of Draw.
  Result<Duration> TimeFrame(const scene::Scene& scene, int width_px, int height_px);

  // To be called before a window's screen goes.
  void CloseWindow() { window_ = gl::Window(); }

  const show::Show& show() const { return prepared_->show(); }
  const std::string& renderer() const { return context_->renderer(); }

 private:
  // The canvas has this size, and the antialiasing that the painter wants, from here on. Errors: as gl::Canvas::Make.
  Result<void> Resize(int width_px, int height_px);
  // Copies the canvas into a window of the screen (an EGL surface's native window).
  Result<void> ShowIn(void* window);
  Studio(std::unique_ptr<gl::Context> context, std::unique_ptr<PreparedShow> prepared)
      : context_(std::move(context)), prepared_(std::move(prepared)) {}

  std::unique_ptr<gl::Context> context_;  // First in, last out: the rest lives in it.
  std::unique_ptr<PreparedShow> prepared_;
  std::unique_ptr<passes::Painter> painter_;
  // What was drawn last, at the size of the screen; the window that it was shown in, where the screen has
  // one.
  gl::Canvas canvas_;
  gl::Window window_;
  std::optional<passes::ScreenPass> screen_pass_;
  std::optional<gl::Target> small_;
  gl::Target asked_target_;  // Of AskPicture.
  gl::Readback readback_;
  // Some of the drawing's shaders were never used.
  bool unprepared_ = true;
  std::uint64_t one_of_ = 1, asked_ = 0;
  bool drew_ = false;
};

}  // namespace kaori::stage
