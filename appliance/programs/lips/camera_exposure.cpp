#include "appliance/programs/lips/camera_exposure.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/ranges.h>

#include "drivers/base/log.h"

namespace kaori::lips {
namespace {

constexpr int kEvery = 8;                               // Every eighth row and column is sampled.
constexpr Duration kFinding = std::chrono::seconds(2);  // A camera needs as long to find its exposure.
// The limit for a camera that says it could expose longer; some report what was set by hand long ago.
constexpr Duration kFindingLimit = 2 * kFinding;
constexpr float kBlack = 0.08F;  // The lens is covered, or the light is off.
constexpr float kDark = 0.25F;   // Skin at a fifteenth of full light, where noise hides the paint.
// A camera that uses this part of its longest exposure can hardly expose more.
constexpr float kFullyExposed = 0.8F;

}  // namespace

// From the histogram of a grid of samples: the level above which a tenth of them lies. Studio range (16 to
// 235) is stretched where the camera says that it sends that.
float BrightnessOf(const decode::Planes& planes) {
  std::array<int, 256> counts{};
  int all = 0;
  for (int y = 0; y < planes.y.height_px; y += kEvery)
    for (int x = 0; x < planes.y.width_px; x += kEvery, ++all) ++counts[planes.y.at(x, y)];
  int brighter = 0;
  int level = 255;
  while (level > 0 && (brighter += counts[static_cast<std::size_t>(level)]) * 10 < all) --level;
  const auto luma = static_cast<float>(level);
  return std::clamp(planes.full_range ? luma / 255 : (luma - 16) / 219, 0.0F, 1.0F);
}

// Another opening means another search, and a mode that may have changed is one line in the log. Of another model
// nothing is held: it finds its exposure by itself, as the first one did.
void CameraExposure::Opened() {
  finding_since_.reset();
  if (tuning_ == nullptr) return;
  if (held_ && !tuning_->holds()) {
    held_ = dark_logged_ = false;
    Log("lip camera: another one; exposure and colours are found anew");
  }
  if (tuning_->mode() == mode_) return;
  mode_ = tuning_->mode();
  Log("lip camera: {}", mode_);
}

// Held or still finding: the picture need not be looked at.
bool CameraExposure::Observe(const decode::Planes& planes, Time now) {
  if (tuning_ == nullptr || held_) return false;
  if (finding_since_ && now - *finding_since_ < kFinding) return false;
  return Judge(planes, now);
}

// A covered lens starts the search anew, so that exposure is never held in the dark. A picture that is too
// dark is believed only when the camera says that it exposes as long as it can, or after twice the time.
bool CameraExposure::Judge(const decode::Planes& planes, Time now) {
  const float brightness = BrightnessOf(planes);
  if (brightness < kBlack) finding_since_.reset();
  if (brightness < kBlack) return false;
  if (!finding_since_) finding_since_ = now;
  if (now - *finding_since_ < kFinding) return false;
  if (brightness >= kDark) {
    HoldUnlessFreed();
    return false;
  }
  const bool exposes_more = tuning_->exposure().value_or(1) < kFullyExposed;
  if (exposes_more && now - *finding_since_ < kFindingLimit) return false;
  if (tuning_->Slower()) {
    LogWarning("lip camera: the picture is too dark at {}; a slower rate is used", mode_);
    return true;
  }
  if (!std::exchange(dark_logged_, true))
    LogWarning(
        "lip camera: the picture is too dark, and the camera has no slower rate; more light on the lips is "
        "needed");
  HoldUnlessFreed();
  return false;
}

// Whoever frees the exposure for a calibration has to hold it again: it is not held in the midst of one.
void CameraExposure::HoldUnlessFreed() {
  if (!freed_) Hold();
}

// A calibration begins anew: what was decided about darkness before it is forgotten.
void CameraExposure::Free() {
  held_ = false;
  freed_ = true;
  dark_logged_ = false;
  finding_since_.reset();
  if (tuning_ != nullptr) tuning_->Set(ports::CameraHold::kFree);
}

// Controls that the camera lacks are named once: without them the picture may drift during the show. Where no camera
// is there, the next one is held once it has found its exposure.
void CameraExposure::Hold() {
  held_ = true;
  freed_ = false;
  if (tuning_ == nullptr) return;
  const auto missing = tuning_->Set(ports::CameraHold::kHeld);
  held_ = tuning_->holds();
  if (!held_) {
    LogWarning(
        "lip camera: none is there to be held; it will be once it is there and has found its exposure");
    return;
  }
  Log("lip camera: exposure and colours are held as they are");
  if (missing != missing_ && !missing.empty())
    LogWarning("lip camera: these controls cannot be held: {}", fmt::join(missing, ", "));
  missing_ = missing;
}

}  // namespace kaori::lips
