// What a card is told so that a screen shows a picture, from dark.
#pragma once

#include <cstdint>
#include <vector>

#include "drivers/scanout/kms_device.h"
#include "drivers/scanout/kms_output.h"

namespace kaori::scanout {

// The part of a picture that a screen shows: as large as its mode, from the left top.
struct KmsPart {
  std::uint32_t framebuffer = 0;
  int x_px = 0;
  int y_px = 0;
};

// Adds all that the output needs, of whatever state it is in. `mode` is the output's own, as the card knows
// it.
void AddWhole(const KmsOutput& output, std::uint32_t mode, const KmsPart& part,
              std::vector<KmsSetting>& into);

}  // namespace kaori::scanout
