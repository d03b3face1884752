// Which connector of a graphics card shows the picture, through which CRTC and plane, in which mode.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "drivers/base/clock.h"
#include "drivers/scanout/drm_objects.h"

namespace kaori::scanout {

struct KmsOutput {
  std::uint32_t connector = 0;
  std::uint32_t crtc = 0;
  std::uint32_t plane = 0;
  drmModeModeInfo mode{};
};

// The mode that the screen asks for by its EDID; of a screen that asks for none (a broken EDID, or none at
// all) the largest one that every cable carries, up to 1920 x 1080. Nothing where there are no modes.
std::optional<drmModeModeInfo> ChooseMode(std::span<const drmModeModeInfo> modes);

// From one vertical blank to the next; 60 Hz where the mode does not say.
Duration PeriodOf(const drmModeModeInfo& mode);

// The first connected output of the card. Probes no connector that the kernel knows to be empty: reading an
// EDID takes tens of milliseconds. Errors: no_such_device (no screen is plugged in), not_supported (no plane
// can show it).
Result<KmsOutput> FindOutput(int card);

// Whether the kernel has seen the screen leave the connector; asks nothing of the cable.
bool IsUnplugged(int card, std::uint32_t connector);

}  // namespace kaori::scanout
