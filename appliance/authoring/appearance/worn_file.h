// Reads what is worn: the tables "hair", "gear" and "clothes" of a look.
#pragma once

#include "appliance/authoring/sculpt/section.h"
#include "appliance/authoring/appearance/looks.h"

namespace kaori::appearance {

HairLook ReadHair(sculpt::Section s);
GearLook ReadGear(sculpt::Section s);
ClothesLook ReadClothes(sculpt::Section s);

}  // namespace kaori::appearance
