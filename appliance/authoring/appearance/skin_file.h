// Reads where the parts of a face's hide lie: the tables of [skin] in a look.
#pragma once

#include "appliance/authoring/appearance/looks.h"
#include "appliance/core/toml/section.h"

namespace kaori::appearance {

// [skin.lines] and [skin.wrinkles]: an amount, and creases = [{ path = [[x, y], [x, y], [x, y]], half_width,
// strength }]. Faults go to the section, here and below.
Creases ReadCreases(toml::Section s);

CoatLook ReadCoat(toml::Section s);    // [skin.coat]
MetalLook ReadMetal(toml::Section s);  // [skin.metal]
ShellLook ReadShell(toml::Section s);  // [skin.shell]

}  // namespace kaori::appearance
