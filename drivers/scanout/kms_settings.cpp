#include "drivers/scanout/kms_settings.h"

namespace kaori::scanout {

void AddOutputSettings(const KmsOutput& output, std::uint32_t mode, const KmsPart& part,
                       std::vector<KmsSetting>& into) {
  // Everything is set, whatever an earlier program left: a plane may have had another size or position.
  const auto& size = output.chosen.mode;
  into.push_back({output.connector, DRM_MODE_OBJECT_CONNECTOR, "CRTC_ID", output.crtc});
  // Not of every connector: older kernels have no such property.
  if (output.link_is_bad)
    into.push_back({output.connector, DRM_MODE_OBJECT_CONNECTOR, "link-status", DRM_MODE_LINK_STATUS_GOOD});
  into.push_back({output.crtc, DRM_MODE_OBJECT_CRTC, "MODE_ID", mode});
  into.push_back({output.crtc, DRM_MODE_OBJECT_CRTC, "ACTIVE", 1});
  const auto plane = [&](const char* name, std::uint64_t value) {
    into.push_back({output.plane, DRM_MODE_OBJECT_PLANE, name, value});
  };
  plane("FB_ID", part.framebuffer);
  plane("CRTC_ID", output.crtc);
  // SRC_ values are 16.16 fixed point, CRTC_ values whole pixels.
  plane("SRC_X", std::uint64_t(part.x_px) << 16);
  plane("SRC_Y", std::uint64_t(part.y_px) << 16);
  plane("SRC_W", std::uint64_t{size.hdisplay} << 16);
  plane("SRC_H", std::uint64_t{size.vdisplay} << 16);
  plane("CRTC_X", 0);
  plane("CRTC_Y", 0);
  plane("CRTC_W", size.hdisplay);
  plane("CRTC_H", size.vdisplay);
}

void AddCrtcOff(std::uint32_t crtc, std::uint32_t plane, std::vector<KmsSetting>& into) {
  // A CRTC without a mode must not be active, and its plane must be empty: KMS refuses half of it.
  into.push_back({crtc, DRM_MODE_OBJECT_CRTC, "MODE_ID", 0});
  into.push_back({crtc, DRM_MODE_OBJECT_CRTC, "ACTIVE", 0});
  if (plane == 0) return;
  into.push_back({plane, DRM_MODE_OBJECT_PLANE, "FB_ID", 0});
  into.push_back({plane, DRM_MODE_OBJECT_PLANE, "CRTC_ID", 0});
}

}  // namespace kaori::scanout
