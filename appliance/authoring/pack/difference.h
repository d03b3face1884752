// What changed from one show to another, item by item.
#pragma once

#include <string>
#include <vector>

#include "appliance/core/show/show.h"

namespace kaori::authoring {

// One line for each item that differs, with how much: "face "dog": moved by up to 3.20 mm (0.41 mm in
// the mean)". Faces, expressions, props, motions and scenes are matched by their names; one that was
// renamed is gone and new. Empty: the two play alike. Numbers are compared exactly. Both shows must
// be valid (show::CheckShow).
std::vector<std::string> Differences(const show::Show& before, const show::Show& after);

}  // namespace kaori::authoring
