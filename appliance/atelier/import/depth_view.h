// What of a head can be seen from the front.
#pragma once

#include <vector>

#include "appliance/atelier/import/head_shape.h"

namespace kaori::import {

// By vertex: nothing of the head, nor an eyeball, lies more than a little before it.
std::vector<bool> SeenFromFront(const HeadShape& head);

}  // namespace kaori::import
