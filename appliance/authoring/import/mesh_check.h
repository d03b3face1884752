// What makes a model unfit to be a face; every fault is found.
#pragma once

#include <span>

#include "appliance/authoring/import/findings.h"
#include "appliance/authoring/import/model.h"

namespace kaori::import {

// Numbers that are none, a head that is not as large as a head in metres.
void CheckModel(const Model& model, Findings& findings);

// Faces of one cast have equal vertices and equal triangles.
void CheckSameTopology(const Model& reference, const Model& other, Findings& findings);

// Of these triangles none may be flat or turned over in the parameter space, and none flat in space.
void CheckUnfolding(const Model& model, std::span<const Triangle> triangles, Findings& findings);

}  // namespace kaori::import
