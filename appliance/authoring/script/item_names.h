// Names of what is numbered in a show: the words of show.toml.
#pragma once

#include "appliance/core/show/cue_names.h"

namespace kaori::authoring {

using show::kStyleNames;

}  // namespace kaori::authoring
