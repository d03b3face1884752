// Says what is wrong with a cast before it is played. A cast that passes cannot make the composer fail.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::face {

// One line for each fault, naming the face, expression or table and the reason: "face \"dog\": 2806 vertices,
// the topology has 2807". Repeated faults in one item are one line with their number. Empty: nothing is
// wrong.
std::vector<std::string> FindFaults(const Cast& cast);

// The first fault, and how many more there are, as an error. Errors:
//   invalid_argument  the cast has a fault
Result<void> CheckCast(const Cast& cast);

}  // namespace kaori::face
