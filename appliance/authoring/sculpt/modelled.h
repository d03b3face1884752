// A head that was shaped in a modelling tool on the cast's own mesh: it can be mixed with every other face.
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/fit_lids.h"
#include "appliance/authoring/sculpt/recipe.h"
#include "drivers/base/result.h"

namespace kaori::sculpt {

// The file that goes out to the tool (import::ExportedHead) holds eyeballs beside the skin. By this they are
// known when it comes back, whatever the tool has done to names and to the order of vertices: their texture
// coordinates lie in squares of their own, u from 2 to 3 for the character's left and from 3 to 4 for the right.
inline constexpr std::array<float, 2> kEyeTile{2, 3};

// Both sides of a head, which may differ. Centimetres, the frame of Cast.
struct ModelledHead {
  std::vector<glm::dvec3> position;  // By vertex of the cage.
  std::array<Ball, 2> eyes;          // [0] the character's left (+X).
};

// Reads recipe.mesh. Its vertices are found by their texture coordinates, which are those of the cage on the
// reference face (TextureFromUv); where a tool has cut the mesh along seams, copies are one vertex. A ball is what lies in
// an eye's tile: its middle, and half of its mean width. Lids are laid onto the balls (FitLids), as thick as the recipe
// says or as they are in the file, 0.8 to 3 mm; vertices on seams are closed.
//
// Errors: invalid_argument: the file's faults as model::ReadModel says them; vertices of the cage that have no
// place in its texture map; an eyeball that is missing or no ball; a part of the head that lies farther than 60 cm from the origin.
Result<ModelledHead> ReadModelledHead(const Cage& cage, const HalfShape& reference, const Modelled& recipe);

}  // namespace kaori::sculpt
