// What of a painter needs no graphics driver, worked out of a cast beforehand: on any thread, while the
// driver loads.
#pragma once

#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/passes/figure_region.h"
#include "render/passes/head_fit.h"
#include "render/passes/prop_mesh.h"
#include "render/passes/surface.h"

namespace kaori::passes {

// Borrows the cast, as its composer does. Moved into the painter's Open; used once.
struct Preparation {
  // Builds all composites, measures edges and props, and sorts hair.
  explicit Preparation(const face::Cast& cast)
      : composer(cast),
        edges(MeasureEdges(cast)),
        head_fit(cast),
        props(FormsOf(cast.props)),
        worn(SeenWhenWorn(cast)) {}

  face::Composer composer;
  LongestEdges edges;
  HeadFit head_fit;
  // In the order of Cast::props.
  std::vector<PropForm> props;
  // For each face, what is seen of it under its hair and clothes.
  std::vector<Triangles> worn;
};

}  // namespace kaori::passes
