// Shoulders and collar. Clothes of faces that cross-fade melt into each other; where a face wears none, they
// sink.
#pragma once

#include "render/gl/program.h"
#include "render/passes/prop_mesh.h"

namespace kaori::passes {

// Each face's clothes are laid over those before it, in one layer and one depth.
class ClothesPass {
 public:
  // Errors: invalid_argument (a shader).
  static Result<ClothesPass> Open();

  // `faces` as composed, and weighed by the appearance. Clothes breathe, but do not turn with the head.
  void Draw(const Appearance& appearance, const face::Terms& faces) const;

 private:
  // The clothes of one face, in the program that Draw has set.
  void DrawWorn(const Appearance& appearance, std::size_t face) const;

  gl::Program program_;
  int paint_ = -1, sunk_ = -1, opacity_ = -1;
};

}  // namespace kaori::passes
