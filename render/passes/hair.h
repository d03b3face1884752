// Hair: locks with a band of light. It grows out of the head while its face, or the style with hair, fades
// in.
#pragma once

#include "render/gl/program.h"
#include "render/passes/prop_mesh.h"

namespace kaori::passes {

// All hair is one kind of mesh, lit by its tangents (Kajiya and Kay 1989) in the vertex shader.
class HairPass {
 public:
  // Compiles two variants of one shader. Errors: invalid_argument (a shader).
  static Result<HairPass> Open();

  // Draws the hair of all faces that are shown. `share` 0..1: how much of the hair the style shows. Where a
  // lock has not grown to its whole length, samples of its pixels are left out (alpha to coverage) instead of
  // blended, so that nothing needs sorting; it therefore needs a layer with samples.
  void Draw(const Appearance& appearance, float share) const;

 private:
  // Whole hair, and hair that grows: the latter discards samples, which costs more.
  struct Variant {
    gl::Program program;
    int paint = -1;
    int gleam = -1;
    int grown = -1;
  };
  // `defines`: nothing, or GROWTH.
  static Result<Variant> MakeVariant(std::string defines);
  // One prop's locks; `presence` 0..1.
  void DrawLocks(const PropMesh& hair, float presence) const;

  Variant whole_;
  Variant growing_;
};

}  // namespace kaori::passes
