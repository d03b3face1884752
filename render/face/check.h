// Says what is wrong with a cast before it is played. A cast that passes cannot make the composer fail.
#pragma once

#include <string>
#include <vector>

#include "render/face/cast.h"

namespace kaori::face {

// One line for each fault, naming the face, expression or table and the reason: "face \"dog\": 2806 vertices,
// the topology has 2807". Repeated faults in one item are one line with their number. Empty: nothing is
// wrong.
//
// Looked at are: every size and every index against what it counts; every number, which must be finite and
// where it has a range within it; that the parameter space does not fold, for an expression would be carried
// to the wrong side of the fold; that twins are mutual; and that positions lie within 10 m, for beyond they
// are not metres. Pure; never fails, whatever the cast holds.
std::vector<std::string> FindFaults(const Cast& cast);

}  // namespace kaori::face
