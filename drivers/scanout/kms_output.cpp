#include "drivers/scanout/kms_output.h"

#include <fmt/format.h>

#include <cmath>

namespace kaori::scanout {
namespace {

// What any screen and cable of the last fifteen years takes, when the screen itself is silent.
constexpr int kSafeWidth_px = 1920;
constexpr int kSafeHeight_px = 1080;

int Area(const drmModeModeInfo& mode) {
  return mode.hdisplay * mode.vdisplay;
}

bool IsSafe(const drmModeModeInfo& mode) {
  return mode.hdisplay <= kSafeWidth_px && mode.vdisplay <= kSafeHeight_px &&
         (mode.flags & DRM_MODE_FLAG_INTERLACE) == 0;
}

// The CRTCs as bits, in the card's order, that the connector can be driven by.
std::uint32_t PossibleCrtcs(int card, const drmModeConnector& connector) {
  std::uint32_t bits = 0;
  for (int i = 0; i < connector.count_encoders; ++i) {
    const DrmEncoder encoder(drmModeGetEncoder(card, connector.encoders[i]));
    if (encoder) bits |= encoder->possible_crtcs;
  }
  return bits;
}

// The primary plane of the CRTC that stands at `index` in the card's order.
std::optional<std::uint32_t> PrimaryPlane(int card, int index) {
  const DrmPlanes planes(drmModeGetPlaneResources(card));
  for (std::uint32_t i = 0; planes && i < planes->count_planes; ++i) {
    const DrmPlane plane(drmModeGetPlane(card, planes->planes[i]));
    if (!plane || (plane->possible_crtcs >> index & 1) == 0) continue;
    const auto type = FindProperty(card, {plane->plane_id, DRM_MODE_OBJECT_PLANE}, "type");
    if (type && type->value == DRM_PLANE_TYPE_PRIMARY) return plane->plane_id;
  }
  return std::nullopt;
}

Result<KmsOutput> Wire(int card, const drmModeRes& resources, const drmModeConnector& connector) {
  const auto mode = ChooseMode({connector.modes, std::size_t(connector.count_modes)});
  if (!mode) return Fail(std::errc::not_supported, "find a mode of the screen");
  const std::uint32_t crtcs = PossibleCrtcs(card, connector);
  for (int i = 0; i < resources.count_crtcs; ++i) {
    if ((crtcs >> i & 1) == 0) continue;
    if (const auto plane = PrimaryPlane(card, i))
      return KmsOutput{connector.connector_id, resources.crtcs[i], *plane, *mode};
  }
  return Fail(std::errc::not_supported, "find a plane for the screen");
}

}  // namespace

std::optional<drmModeModeInfo> ChooseMode(std::span<const drmModeModeInfo> modes) {
  const drmModeModeInfo* best = nullptr;
  for (const auto& mode : modes) {
    if ((mode.type & DRM_MODE_TYPE_PREFERRED) != 0) return mode;
    if (IsSafe(mode) && (best == nullptr || Area(mode) > Area(*best))) best = &mode;
  }
  if (best == nullptr && !modes.empty()) best = modes.data();
  return best == nullptr ? std::nullopt : std::optional(*best);
}

Duration PeriodOf(const drmModeModeInfo& mode) {
  if (mode.clock == 0 || mode.htotal == 0 || mode.vtotal == 0) return FromSeconds(1.0 / 60);
  return FromSeconds(mode.htotal * 1e-3 * mode.vtotal / mode.clock);  // The clock is in kHz.
}

bool IsUnplugged(int card, std::uint32_t connector) {
  const DrmConnector now(drmModeGetConnectorCurrent(card, connector));
  return !now || now->connection == DRM_MODE_DISCONNECTED;
}

Result<KmsOutput> FindOutput(int card) {
  const DrmResources resources(drmModeGetResources(card));
  if (!resources) return FailErrno("ask the graphics card for its outputs");
  for (int i = 0; i < resources->count_connectors; ++i) {
    const std::uint32_t id = resources->connectors[i];
    if (IsUnplugged(card, id)) continue;
    const DrmConnector connector(drmModeGetConnector(card, id));
    if (connector && connector->connection == DRM_MODE_CONNECTED && connector->count_modes > 0)
      return Wire(card, *resources, *connector);
  }
  return Fail(std::errc::no_such_device, "find a screen on the graphics card");
}

}  // namespace kaori::scanout
