// Paints a scene: composes the face, draws it in the styles that have weight, and cross-fades them.
//
// Styles that share a mesh (the textured ones) are mixed in its shaders; the others are drawn as layers of
// their own and dissolve as whole pictures. One thread: that of the context.
#pragma once

#include <memory>

#include "render/face/composer.h"
#include "render/gl/canvas.h"
#include "render/gl/context.h"
#include "render/passes/quality.h"
#include "render/scene/scene.h"

namespace kaori::passes {

struct Preparation;

// Opened once for a cast and a context; then Draw once a frame. Everything that it shows follows from the
// Scene alone, so a frame can be drawn again: nothing is kept from frame to frame but what saves work.
class Painter {
 public:
  // Compiles shaders and loads textures, which blocks. Borrows the context (current on this thread, as at
  // every later call) and the cast; both outlive the painter. Errors: invalid_argument (a shader; names file
  // and line).
  static Result<std::unique_ptr<Painter>> Open(const gl::Context& context, const face::Cast& cast);
  // The same, with what needs no driver worked out beforehand: `prepared` is of this cast. Blocks less.
  static Result<std::unique_ptr<Painter>> Open(const gl::Context& context, const face::Cast& cast,
                                               Preparation prepared, Quality quality = Quality::kBasic);
  ~Painter();

  Quality quality() const;
  // Draws so from here on. Blocks while shaders compile that were not needed before. Errors: as Open; it then
  // draws as before.
  Result<void> SetQuality(Quality quality);

  // What a canvas is to have for this quality to look as it should, soonest: a processor spends most of a frame on the
  // samples of small triangles. Any other canvas is drawn on, too.
  gl::Antialiasing antialiasing() const;

  // Makes the picture of `scene` on `canvas`, of any size. Values that are none are replaced (see
  // sane_scene.h). Allocates nothing, but where a backdrop's picture, a skin, a caption or a canvas's size is
  // new. Returns when the driver has the commands; the picture is finished when it is read or shown.
  void Draw(const scene::Scene& scene, const gl::Canvas& canvas);

  // The cast's expression of this index is not what it was: see face::Composer::Renew.
  void Renew(std::size_t expression);

  // The face as it was drawn last; empty before the first Draw. Holds until the next Draw or WarmUpStep. For
  // the expression editor, which asks where its handles are.
  const face::Shape& shape() const;

  // Drivers finish a shader when it is first drawn with, and a skin is loaded when it is first shown, which
  // would stall a fade in the middle of the show. One step loads a skin, or draws, unseen, with a shader that
  // the default look has not used; call it between frames, once the first is out, while it returns true: more
  // remain. Blocks for 10 to 40 ms. A canvas that cannot be made is no fault: shaders are then finished when
  // they are needed.
  bool WarmUpStep();

 private:
  // Composer, passes and buffers; in painter_parts.h.
  struct Parts;
  explicit Painter(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace kaori::passes
