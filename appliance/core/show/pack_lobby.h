// The lobby of a show, as a table of a pack.
#pragma once

#include "appliance/core/show/lobby.h"
#include "appliance/core/show/pack_copier.h"

namespace kaori::show {

// The lobby as a table in `to`, which owns it. A null offset where the show has none: the table is then absent. Never
// fails.
flatbuffers::Offset<pack::Lobby> WriteLobby(flatbuffers::FlatBufferBuilder& to,
                                            const std::optional<Lobby>& lobby);

// A table that is absent, as in every pack from before there were lobbies, is none. What does not fit reads
// as what CheckLobby refuses.
std::optional<Lobby> ReadLobby(Copier& from, const pack::Lobby* stored);

}  // namespace kaori::show
