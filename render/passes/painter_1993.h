// The load of the 1994 paper, for comparison: the cage alone, textured, one lamp, no smooth edges.
#pragma once

#include <memory>

#include "render/face/cast.h"
#include "render/gl/canvas.h"
#include "render/gl/context.h"
#include "render/scene/scene.h"

namespace kaori::passes {

class Painter1993 {
 public:
  // As Painter::Open.
  static Result<std::unique_ptr<Painter1993>> Open(const gl::Context& context, const face::Cast& cast);
  ~Painter1993();

  // As Painter::Draw, on a canvas without samples that takes codes. Styles, hair and gaze are not looked at;
  // the heaviest face lends its texture.
  void Draw(const scene::Scene& scene, const gl::Canvas& canvas);

 private:
  struct Parts;
  explicit Painter1993(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace kaori::passes
