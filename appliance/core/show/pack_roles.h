// Roles in a pack's content.
#pragma once

#include "appliance/core/show/pack_copier.h"

namespace kaori::show {

// The roles as a table in `to`, which owns it; the offset is good until `to` is finished. Equal roles give equal bytes.
// Never fails.
flatbuffers::Offset<pack::Roles> WriteRoles(flatbuffers::FlatBufferBuilder& to, const Roles& roles);

// The inverse. A table that is absent, as in every pack from before there were roles, is that of the usual ones. What
// it reads is not checked (see check.h); what `from` has no bytes left for is empty.
Roles ReadRoles(Copier& from, const pack::Roles* stored);

}  // namespace kaori::show
