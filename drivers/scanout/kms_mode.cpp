#include "drivers/scanout/kms_mode.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace kaori::scanout {
namespace {

// What any screen and cable of the last fifteen years carries, for a screen that prefers no mode.
constexpr int kSafeWidth_px = 1920;
constexpr int kSafeHeight_px = 1080;
constexpr int kFurthest_px = 16384;  // No card shows more in one piece.
constexpr int kFastest_hz = 1000;

// VESA DMT 0x04: 640 x 480 at 60 Hz.
constexpr drmModeModeInfo LastResort() {
  drmModeModeInfo mode{};
  mode.clock = 25175;
  mode.hdisplay = 640;
  mode.hsync_start = 656;
  mode.hsync_end = 752;
  mode.htotal = 800;
  mode.vdisplay = 480;
  mode.vsync_start = 490;
  mode.vsync_end = 492;
  mode.vtotal = 525;
  mode.vrefresh = 60;
  mode.flags = DRM_MODE_FLAG_NHSYNC | DRM_MODE_FLAG_NVSYNC;
  return mode;
}

// In pixels.
int Area(const drmModeModeInfo& mode) {
  return mode.hdisplay * mode.vdisplay;
}

// A broken EDID can claim any size.
bool IsValid(const drmModeModeInfo& mode) {
  return mode.hdisplay > 0 && mode.vdisplay > 0 && mode.hdisplay <= kFurthest_px &&
         mode.vdisplay <= kFurthest_px;
}

// Interlaced modes flicker, and some screens refuse them.
bool IsSafe(const drmModeModeInfo& mode) {
  return mode.hdisplay <= kSafeWidth_px && mode.vdisplay <= kSafeHeight_px &&
         (mode.flags & DRM_MODE_FLAG_INTERLACE) == 0;
}

// CVT 1.2, reduced blanking: 160 pixels beside, and at least 460 us above and below.
drmModeModeInfo Timed(int width_px, int height_px, int rate_hz) {
  constexpr double kBlank_s = 460e-6;
  constexpr int kFront = 3, kSync = 4, kLeastBack = 6;
  // The time of a line, from which the number of blank lines follows.
  const double line_s = (1.0 / rate_hz - kBlank_s) / height_px;
  const int blank = std::max(int(std::ceil(kBlank_s / line_s)) + 1, kFront + kSync + kLeastBack);
  drmModeModeInfo mode{};
  mode.hdisplay = std::uint16_t(width_px);
  // VESA CVT 1.2, reduced blanking version 1: 48 pixels of front porch, 32 of sync, 80 of back porch.
  mode.hsync_start = std::uint16_t(width_px + 48);
  mode.hsync_end = std::uint16_t(width_px + 48 + 32);
  mode.htotal = std::uint16_t(width_px + 160);
  mode.vdisplay = std::uint16_t(height_px);
  mode.vsync_start = std::uint16_t(height_px + kFront);
  mode.vsync_end = std::uint16_t(height_px + kFront + kSync);
  mode.vtotal = std::uint16_t(height_px + blank);
  // In kHz. CVT rounds down to steps of 250 kHz, which would miss the rate that
  // was asked for; no screen insists.
  mode.clock = std::uint32_t(std::lround(1e-3 * mode.htotal * mode.vtotal * rate_hz));
  mode.vrefresh = std::uint32_t(rate_hz);
  // The polarities by which a screen recognises reduced blanking.
  mode.flags = DRM_MODE_FLAG_PHSYNC | DRM_MODE_FLAG_NVSYNC;
  mode.type = DRM_MODE_TYPE_USERDEF;
  return mode;
}

// The number that `text` begins with, and `ends` behind it; both are removed from `text`. None where it
// is below 1 or above `most`, or where something else follows.
std::optional<int> ReadNumber(std::string_view& text, std::string_view ends, int most) {
  int value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(std::size_t(read.ptr - text.data()));
  if (read.ec != std::errc() || value < 1 || value > most || !text.starts_with(ends)) return std::nullopt;
  text.remove_prefix(ends.size());
  return value;
}

}  // namespace

// The screen's own preferred mode, else the largest that is safe for any screen, else the first that is valid
// at all, else one that every screen is expected to show.
ChosenMode ChooseMode(std::span<const drmModeModeInfo> modes) {
  const drmModeModeInfo* safe = nullptr;
  const drmModeModeInfo* any = nullptr;
  for (const auto& mode : modes) {
    if (!IsValid(mode)) continue;
    if ((mode.type & DRM_MODE_TYPE_PREFERRED) != 0) return {mode, ports::ModeOrigin::kWanted};
    if (IsSafe(mode) && (safe == nullptr || Area(mode) > Area(*safe))) safe = &mode;
    if (any == nullptr) any = &mode;
  }
  const auto* const best = safe != nullptr ? safe : any;
  return {best == nullptr ? LastResort() : *best};
}

std::optional<drmModeModeInfo> ParseMode(std::string_view text) {
  const auto width_px = ReadNumber(text, "x", kFurthest_px);
  const auto height_px = width_px ? ReadNumber(text, "@", kFurthest_px) : std::nullopt;
  const auto rate_hz = height_px ? ReadNumber(text, "", kFastest_hz) : std::nullopt;
  if (!rate_hz || !text.empty()) return std::nullopt;
  return Timed(*width_px, *height_px, *rate_hz);
}

Duration PeriodOf(const drmModeModeInfo& mode) {
  // Modes of virtual machines have no timings.
  if (mode.clock == 0 || mode.htotal == 0 || mode.vtotal == 0) return FromSeconds(1.0 / 60);
  return FromSeconds(mode.htotal * 1e-3 * mode.vtotal / mode.clock);  // The clock is in kHz.
}

}  // namespace kaori::scanout
