// The properties that a commit sets so that a dark screen shows a picture (KMS properties, drm-kms:
// standard connector, CRTC and plane properties).
#pragma once

#include <cstdint>
#include <vector>

#include "drivers/scanout/kms_device.h"
#include "drivers/scanout/kms_output.h"

namespace kaori::scanout {

// The part of a framebuffer that a screen shows, from its left top; as large as the
// screen's mode. Nothing is scaled.
struct KmsPart {
  // KMS's number of the framebuffer.
  std::uint32_t framebuffer = 0;
  int x_px = 0;
  int y_px = 0;
};

// Adds to `into` every property that the output needs, whatever state it is in: 13 of them, or 14 after its link
// failed. `mode` is the blob of the output's mode. A commit of them needs DRM_MODE_ATOMIC_ALLOW_MODESET. Pure.
void AddOutputSettings(const KmsOutput& output, std::uint32_t mode, const KmsPart& part,
                       std::vector<KmsSetting>& into);

// Adds every property that turns the CRTC off, and its plane with it; `plane` 0: it has none. Its
// connector must be taken off the CRTC by the same commit. Pure.
void AddCrtcOff(std::uint32_t crtc, std::uint32_t plane, std::vector<KmsSetting>& into);

}  // namespace kaori::scanout
