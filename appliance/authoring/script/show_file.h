// Reads show.toml: what each control of the operators calls up.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "appliance/core/show/show.h"

namespace kaori::authoring {

// Which names of the cast there are to be compared with. Where a file of the cast cannot be read nobody knows
// which faces or expressions exist, and none is said to be missing.
struct KnownNames {
  bool faces = true;
  bool expressions = true;
};

// Fills buttons of the dial box and of sticks, keys, motions, takes (files of takes/ beside `file`), scenes, channels and, where there is a
// cues.toml beside `file`, the cue list of `show`, whose cast must be there: names are looked up in it; where
// there is a lobby.toml, the lobby.
// Pictures of backdrops are appended to the cast's textures. Returns every fault found, one line each: file,
// line, item, reason; empty when all is well, and then show::CheckShow finds nothing wrong with what was
// read. With faults, `show` is filled in part and must not be used.
std::vector<std::string> ReadShowFile(const std::filesystem::path& file, show::Show& show,
                                      KnownNames known = {});

}  // namespace kaori::authoring
