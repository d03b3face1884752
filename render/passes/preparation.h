// What of a painter needs no graphics driver, worked out of a cast beforehand: on any thread, while the
// driver loads.
#pragma once

#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/passes/figure_region.h"
#include "render/passes/head_fit.h"
#include "render/passes/prop_mesh.h"
#include "render/passes/skin_texture.h"
#include "render/passes/surface.h"

namespace kaori::passes {

// Borrows the cast, as its composer does. Moved into the painter's Open; used once.
struct Preparation {
  // Builds all composites, measures edges and props, sorts hair, and makes the skin of `first_face`, which is to be shown
  // first: a face of the cast.
  explicit Preparation(const face::Cast& cast, std::size_t first_face = 0)
      : composer(cast),
        edges(MeasureEdges(cast)),
        head_fit(cast),
        props(FormsOf(cast.props)),
        worn(SeenWhenWorn(cast)) {
    if (first_face >= cast.faces.size()) return;
    first_skin = cast.faces[first_face].surface.texture;
    if (static_cast<std::size_t>(first_skin) < cast.textures.size())
      skin = SkinLevels(cast.textures[static_cast<std::size_t>(first_skin)]);
  }

  face::Composer composer;
  LongestEdges edges;
  HeadFit head_fit;
  // In the order of Cast::props.
  std::vector<PropForm> props;
  // For each face, what is seen of it under its hair and clothes.
  std::vector<Triangles> worn;
  // Of the texture of this index; empty where the cast has none.
  int first_skin = 0;
  std::vector<gl::MipLevel> skin;
};

}  // namespace kaori::passes
