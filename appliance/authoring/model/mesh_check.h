// What makes a model unfit to be a face; every fault is found.
#pragma once

#include <span>

#include "appliance/authoring/model/findings.h"
#include "appliance/authoring/model/model.h"

namespace kaori::model {

// Faults: no vertices; positions, texture coordinates or offsets that are not finite; a head smaller than 2
// cm or larger than 3 m, which is the sign of a file in centimetres or inches.
void CheckModel(const Model& model, Findings& findings);

// Faces of one cast have equally many vertices and equal triangles in equal order. Texture coordinates may
// differ; the first file's count.
void CheckSameTopology(const Model& reference, const Model& other, Findings& findings);

// Of these triangles of `model` none may be flat or turned over in the parameter space (negative area, v up),
// and none flat in space. Control points are interpolated and painted there: a fold would tear a smile.
// Slivers up to 2 % of the mean triangle may be turned over, as they are found in corners of real eyes.
void CheckUnfolding(const Model& model, std::span<const Triangle> triangles, Findings& findings);

}  // namespace kaori::model
