// A head of hair, cut to a look.
#pragma once

#include <string>

#include "appliance/authoring/appearance/cloth_mesh.h"
#include "appliance/authoring/appearance/looks.h"

namespace kaori::appearance {

// A bob: a curtain from the temples round the back, a fringe, and locks over both. About 12 000 triangles.
// Adds the hair to `mesh`, in centimetres; the look must be one that was read without a fault. What varies
// from lock to lock comes of look.seed, the same on every machine.
void CutBob(ClothMesh& mesh, const HairLook& look);

// Short hair, combed back from the hairline; the nape as in a bob. Needs look.hairline_deg.
void CutSwept(ClothMesh& mesh, const HairLook& look);

// A cap close to the skull that closes every gap to the scalp; single-sided.
void AddCap(ClothMesh& mesh, const HairLook& look);
// The curtain from `opens_at_deg` round the back, with as many locks over it.
void AddCurtain(ClothMesh& mesh, const HairLook& look, int locks);

}  // namespace kaori::appearance
