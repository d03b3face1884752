// The levels that the show's roles play or that somebody has, and who plays which role.
#pragma once

#include <vector>

#include "appliance/programs/monitor/view.h"

namespace kaori::monitor {

// In the order of show::Level. A level that no role plays and nobody has is left out. Those of mixes bear the name of
// the face or expression that their role gives them. Pure.
std::vector<Level> LevelsOf(const Moment& moment);

// As "head: left stick", in the order of the show's roles; a role that nobody plays is quiet. Pure.
std::vector<Tag> RolesOf(const Moment& moment);

}  // namespace kaori::monitor
