// Shoulders and collar. Of faces that cross-fade each dresses a part of the picture of its own, from the
// collar down, and the parts wander; where a face has no neck to wear them on, clothes sink out of the
// picture.
#pragma once

#include "render/gl/program.h"
#include "render/passes/dressing.h"
#include "render/passes/frame.h"
#include "render/passes/prop_mesh.h"

namespace kaori::passes {

// Each face's clothes are laid over those before it, in one layer and one depth.
class ClothesPass {
 public:
  // Errors: invalid_argument (a shader).
  static Result<ClothesPass> Open();

  // `dressing` of the faces that the appearance was weighed for. Clothes breathe and lean with the head, but
  // do not turn with it. No pixel shows garments of two faces, and what replaces each other is of one colour
  // meanwhile, so that the border is not seen.
  void Draw(const Appearance& appearance, const Dressing& dressing, const FrameBlock& frame) const;

 private:
  // Clothes as they were sewn, and clothes that give way to others: the latter discards fragments, which
  // costs more.
  struct Variant {
    gl::Program program;
    int paint = -1, fit = -1, outline = -1, collar = -1, neck = -1;
  };
  static Result<Variant> MakeVariant(std::string defines);
  // The clothes of one face, in the program that Draw has set.
  static void DrawWorn(const Appearance& appearance, const Variant& variant, const Dressing& dressing,
                       std::size_t face);

  Variant whole_;
  Variant changing_;
};

}  // namespace kaori::passes
