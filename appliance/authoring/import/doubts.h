// What makes a head unfit for a stage though every number of its file is sound.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/heads.h"

namespace kaori::import {

// Faults of how the first head stands in its file, which is `model`: far more of its eyes is seen from another side than from where it should look to (it
// looks along another axis than +Z, as heads do that come with +Z up or turned about); or what was taken for one eyeball is
// several (two heads in one file, or a head that looks aside).
void CheckPose(const Model& model, const Heads& heads, Findings& findings);

// Nothing here keeps a head from being imported: an author at work wants to see how far it is.
//
// What an audience would see, a sentence each with what to do; empty where all is well. `head` is ShapeOfHeads(heads),
// `marks` its landmarks, where they are known; `moving` how many vertices any expression moves.
std::vector<std::string> DoubtsAbout(const Heads& heads, const HeadShape& head,
                                     const std::vector<Landmark>& marks, Index moving);

}  // namespace kaori::import
