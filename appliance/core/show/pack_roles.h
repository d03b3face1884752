// Roles in a pack's content.
#pragma once

#include "appliance/core/show/pack_copier.h"

namespace kaori::show {

flatbuffers::Offset<pack::Roles> WriteRoles(flatbuffers::FlatBufferBuilder& to, const Roles& roles);

// Absent: the usual ones. What it reads is not checked (see check.h).
Roles ReadRoles(Copier& from, const pack::Roles* stored);

}  // namespace kaori::show
