// The command kaori-atelier import.
#pragma once

#include <span>

namespace kaori::import {

inline constexpr const char* kImportHelp =
    "  kaori-atelier import FILE... --out FOLDER_OR_PACK [--show PACK] [--points N]\n"
    "                                   faces made in modelling tools (.glb, .gltf, .obj): the heads as a pack; with a\n"
    "                                   show, its expressions on them and theirs on its faces; and a report\n";

// `args`: what stands after the verb. Says on stdout what was mapped and what was written. The program's status.
int ImportCommand(std::span<char*> args);

}  // namespace kaori::import
