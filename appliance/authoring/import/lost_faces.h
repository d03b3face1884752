// A show's calls of faces that an imported cast has not.
#pragma once

#include "appliance/core/show/show.h"

namespace kaori::import {

// Buttons and keys that call a lost face call nothing; scenes show the first face instead. So do levels of
// roles, which keep their numbers.
void DropLostFaces(show::Show& show);

}  // namespace kaori::import
