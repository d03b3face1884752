// Reads what is worn: the tables "hair", "gear" and "clothes" of a look.
#pragma once

#include "appliance/authoring/appearance/looks.h"
#include "appliance/core/toml/section.h"

namespace kaori::appearance {

HairLook ReadHair(toml::Section s);
GearLook ReadGear(toml::Section s);
ClothesLook ReadClothes(toml::Section s);

}  // namespace kaori::appearance
