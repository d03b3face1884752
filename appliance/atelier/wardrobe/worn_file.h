// Reads what is worn: the tables "hair", "gear" and "clothes" of a look.
#pragma once

#include "appliance/atelier/sculpt/section.h"
#include "appliance/atelier/wardrobe/looks.h"

namespace kaori::wardrobe {

HairLook ReadHair(sculpt::Section s);
GearLook ReadGear(sculpt::Section s);
ClothesLook ReadClothes(sculpt::Section s);

}  // namespace kaori::wardrobe
