// The control net of a cast: its points, and the interpolant from them to the cage.
#pragma once

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/expression_file.h"
#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::sculpt {

// Points in the order of the file; the left one of a pair (".l") before the right one (".r").
//
// The interpolant begins piecewise linear, as the paper's, over the Delaunay triangulation of the left half
// of the parameter space, mirrored, so that left and right never differ. What lies behind the edges of lips
// and lids has no position of its own in it and borrows that of the edge, fading into the mouth. to_cage is
// that matrix after three smoothing steps over the mesh and six more around the lips; the edges themselves
// stay as they are, so that the slits remain sharp.
//
// Errors: invalid_argument where the points do not span a plane, or leave a part of the face without a
// triangle; the attempt names the place in centimetres.
Result<face::ControlNet> MakeControlNet(const Cage& cage, const HalfShape& reference,
                                        const ExpressionFile& file);

}  // namespace kaori::sculpt
