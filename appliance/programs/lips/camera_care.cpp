#include "appliance/programs/lips/camera_care.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/ranges.h>

#include "drivers/base/log.h"

namespace kaori::lips {
namespace {

constexpr int kEvery = 8;                               // Row and column that is looked at.
constexpr Duration kFinding = std::chrono::seconds(2);  // What a camera takes to find its exposure.
constexpr Duration kPatience = 2 * kFinding;            // Even if it says that it could expose longer:
                                                        // some tell what was set by hand long ago.
constexpr float kBlack = 0.08F;                         // The lens is covered, or the light is off.
constexpr float kDark = 0.25F;  // Skin at a fifteenth of full light: noise eats the paint.
constexpr float kFullyExposed = 0.8F;

}  // namespace

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

void CameraCare::Opened() {
  finding_since_.reset();
  if (tuning_ == nullptr || tuning_->mode() == mode_) return;
  mode_ = tuning_->mode();
  Log("lip camera: {}", mode_);
}

bool CameraCare::See(const decode::Planes& planes, Time now) {
  if (tuning_ == nullptr || held_) return false;
  if (finding_since_ && now - *finding_since_ < kFinding) return false;
  return Judge(planes, now);
}

bool CameraCare::Judge(const decode::Planes& planes, Time now) {
  const float brightness = BrightnessOf(planes);
  if (brightness < kBlack) finding_since_.reset();
  if (brightness < kBlack) return false;
  if (!finding_since_) finding_since_ = now;
  if (now - *finding_since_ < kFinding) return false;
  if (brightness >= kDark) {
    Found();
    return false;
  }
  const bool exposes_more = tuning_->exposure().value_or(1) < kFullyExposed;
  if (exposes_more && now - *finding_since_ < kPatience) return false;
  if (tuning_->Slower()) {
    LogWarning("lip camera: too dark at {}; slower", mode_);
    return true;
  }
  if (!std::exchange(told_dark_, true))
    LogWarning("lip camera: too dark, and none of its rates is slower: light the lips");
  Found();
  return false;
}

void CameraCare::Found() {
  if (!by_hand_) Hold();
}

void CameraCare::Free() {
  held_ = false;
  by_hand_ = true;
  told_dark_ = false;
  finding_since_.reset();
  if (tuning_ != nullptr) tuning_->Set(ports::CameraHold::kFree);
}

void CameraCare::Hold() {
  held_ = true;
  by_hand_ = false;
  if (tuning_ == nullptr) return;
  const auto lacks = tuning_->Set(ports::CameraHold::kHeld);
  Log("lip camera: held as it is");
  if (lacks != lacks_ && !lacks.empty()) LogWarning("lip camera: cannot be held: {}", fmt::join(lacks, ", "));
  lacks_ = lacks;
}

}  // namespace kaori::lips
