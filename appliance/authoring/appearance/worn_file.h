// Reads what is worn: the tables "hair", "gear" and "clothes" of a look.
#pragma once

#include "appliance/authoring/appearance/looks.h"
#include "appliance/core/toml/section.h"

namespace kaori::appearance {

// Faults go to the section: words and keys that do not exist, lengths that are no centimetres, angles
// out of range.
HairLook ReadHair(toml::Section s);
GearLook ReadGear(toml::Section s);
ClothesLook ReadClothes(toml::Section s);

}  // namespace kaori::appearance
