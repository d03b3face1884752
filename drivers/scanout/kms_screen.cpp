#include "drivers/scanout/kms_screen.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace kaori::scanout {
namespace {

using namespace std::chrono_literals;

constexpr Duration kLookPeriod = 250ms;  // How often connectors are looked at.
constexpr Duration kLongestFlip = 2s;    // A card that takes longer has lost the frame.

// Whose flip an event is: a dead program's comes by through the same file, and is not ours.
std::uint64_t TokenOf(std::uint64_t frame) {
  return std::uint64_t(::getpid()) << 32 | (frame & 0xffffffff);
}

}  // namespace

Result<std::unique_ptr<KmsScreen>> KmsScreen::Open(KmsDevice& card, const MakePictures& make,
                                                   const Clock& clock,
                                                   const std::optional<drmModeModeInfo>& mode) {
  auto outputs = FindOutputs(card, mode);
  if (!outputs) return tl::unexpected(outputs.error());
  KmsWall wall = Arrange(std::move(*outputs));
  auto pictures = make(wall.width_px, wall.height_px);
  if (!pictures) return tl::unexpected(pictures.error());
  return std::unique_ptr<KmsScreen>(new KmsScreen(card, std::move(wall), std::move(*pictures), clock, mode));
}

KmsScreen::KmsScreen(KmsDevice& card, KmsWall wall, std::unique_ptr<KmsPictures> pictures, const Clock& clock,
                     const std::optional<drmModeModeInfo>& mode)
    : card_(card),
      wall_(std::move(wall)),
      pictures_(std::move(pictures)),
      clock_(clock),
      mode_(mode),
      looked_(clock.now()) {
  for (const KmsPanel& panel : wall_.panels) panels_.push_back({panel});
  for (const std::uint32_t connector : card_.Connectors())
    if (IsNewcomer(connector) && card_.PlugOf(connector) == Plug::kPlugged) seen_.push_back(connector);
  constexpr std::size_t kMostSettings = 13;  // Of one screen.
  settings_.reserve(panels_.size() * kMostSettings);
}

// The card keeps a mode for as long as it shows it.
KmsScreen::~KmsScreen() {
  for (const Panel& panel : panels_)
    if (panel.mode != 0) card_.ForgetMode(panel.mode);
}

Result<ports::PixelBuffer> KmsScreen::Acquire() {
  const Time now = clock_.now();
  if (now - looked_ >= kLookPeriod) {
    looked_ = now;
    if (auto looked = Look(); !looked) return tl::unexpected(looked.error());
  }
  if (Owes() || shown_) {
    if (now - presented_at_ > kLongestFlip)
      return Fail(std::errc::no_such_device, "await a flip of the screen");
    return Fail(std::errc::resource_unavailable_try_again, "draw for the screen");
  }
  acquired_ = true;
  return ports::PixelBuffer{wall_.width_px, wall_.height_px, {}, pictures_->window()};
}

// The kernel's own view is that of the last probe; a screen that is lit may have given way to another one.
Result<void> KmsScreen::Ask() {
  for (const std::uint32_t connector : card_.Connectors()) {
    const auto found = card_.Probe(connector);
    const auto panel =
        std::ranges::find(panels_, connector, [](const Panel& p) { return p.at.output.connector; });
    if (found && found->plugged && panel != panels_.end() && !IsAsBefore(*found, *panel))
      return Fail(std::errc::no_such_device, "leave the screens as they were: one has another mode");
  }
  return {};
}

bool KmsScreen::IsAsBefore(const KmsConnector& connector, const Panel& panel) const {
  const auto& now = ModeFor(connector, mode_).mode;
  const auto& before = panel.at.output.chosen.mode;
  return now.hdisplay == before.hdisplay && now.vdisplay == before.vdisplay;
}

Result<void> KmsScreen::Look() {
  if (card_.Stirred())
    if (auto asked = Ask(); !asked) return asked;
  for (const std::uint32_t connector : card_.Connectors()) {
    const bool plugged = card_.PlugOf(connector) == Plug::kPlugged;
    if (!plugged) std::erase(seen_, connector);
    if (plugged && IsNewcomer(connector))
      return Fail(std::errc::no_such_device, "leave the screens as they were: another one was plugged in");
  }
  for (Panel& panel : panels_)
    if (auto looked = LookAt(panel); !looked) return looked;
  if (First() == nullptr) return Fail(std::errc::no_such_device, "draw for the screen");
  return {};
}

bool KmsScreen::IsNewcomer(std::uint32_t connector) const {
  return std::ranges::find(seen_, connector) == seen_.end() &&
         std::ranges::none_of(panels_, [&](const Panel& p) { return p.at.output.connector == connector; });
}

Result<void> KmsScreen::LookAt(Panel& panel) {
  const std::uint32_t connector = panel.at.output.connector;
  const bool plugged = card_.PlugOf(connector) == Plug::kPlugged;
  if (!plugged) {
    panel.light = Light::kDark;
    panel.flips = false;
    return {};
  }
  if (panel.light != Light::kDark) return {};
  const auto back = card_.Probe(connector);
  if (!back || !back->plugged) return {};
  if (!IsAsBefore(*back, panel))
    return Fail(std::errc::no_such_device, "leave the screens as they were: one came back with another mode");
  panel.light = Light::kNew;
  return {};
}

Result<void> KmsScreen::Present(std::uint64_t frame) {
  if (!std::exchange(acquired_, false)) return Fail(std::errc::invalid_argument, "present without a buffer");
  const auto framebuffer = pictures_->LockFront();
  if (!framebuffer) return tl::unexpected(framebuffer.error());
  frame_ = frame;
  if (auto shown = Commit(*framebuffer); !shown) return shown;
  presented_at_ = clock_.now();
  for (Panel& panel : panels_) panel.flips = panel.light != Light::kDark;
  return {};
}

// Where a screen shows the same mode already, as after a restart, the kernel changes the picture alone.
Result<void> KmsScreen::Commit(std::uint32_t framebuffer) {
  settings_.clear();
  bool sets_modes = false;
  if (!alone_) AddOthersOff();
  for (Panel& panel : panels_) {
    if (panel.light == Light::kDark) continue;
    if (panel.light == Light::kLit) {
      settings_.push_back({panel.at.output.plane, DRM_MODE_OBJECT_PLANE, "FB_ID", framebuffer});
      continue;
    }
    if (auto added = AddAll(panel, framebuffer); !added) return added;
    sets_modes = true;
  }
  return card_.Commit(settings_, TokenOf(frame_), sets_modes);
}

Result<void> KmsScreen::AddAll(Panel& panel, std::uint32_t framebuffer) {
  const KmsOutput& output = panel.at.output;
  const auto& mode = output.chosen.mode;
  if (panel.mode == 0) {
    const auto told = card_.TellMode(mode);
    if (!told) return tl::unexpected(told.error());
    panel.mode = *told;
  }
  settings_.push_back({output.connector, DRM_MODE_OBJECT_CONNECTOR, "CRTC_ID", output.crtc});
  settings_.push_back({output.crtc, DRM_MODE_OBJECT_CRTC, "MODE_ID", panel.mode});
  settings_.push_back({output.crtc, DRM_MODE_OBJECT_CRTC, "ACTIVE", 1});
  const auto plane = [&](const char* name, std::uint64_t value) {
    settings_.push_back({output.plane, DRM_MODE_OBJECT_PLANE, name, value});
  };
  plane("FB_ID", framebuffer);
  plane("CRTC_ID", output.crtc);
  // The part of the picture, in 1/65536 of a pixel.
  plane("SRC_X", std::uint64_t(panel.at.x_px) << 16);
  plane("SRC_Y", std::uint64_t(panel.at.y_px) << 16);
  plane("SRC_W", std::uint64_t{mode.hdisplay} << 16);
  plane("SRC_H", std::uint64_t{mode.vdisplay} << 16);
  plane("CRTC_X", 0);
  plane("CRTC_Y", 0);
  plane("CRTC_W", mode.hdisplay);
  plane("CRTC_H", mode.vdisplay);
  return {};
}

// What an earlier program showed elsewhere, on a screen that has gone since, ends: its CRTC may be needed.
void KmsScreen::AddOthersOff() {
  const auto is_ours = [this](std::uint32_t KmsOutput::*part, std::uint32_t id) {
    return std::ranges::any_of(panels_, [&](const Panel& p) { return p.at.output.*part == id; });
  };
  for (const std::uint32_t connector : card_.Connectors())
    if (!is_ours(&KmsOutput::connector, connector))
      settings_.push_back({connector, DRM_MODE_OBJECT_CONNECTOR, "CRTC_ID", 0});
  const auto crtcs = card_.Crtcs();
  const auto planes = PlanesOf(card_, crtcs.size());
  for (std::size_t i = 0; i < crtcs.size(); ++i) {
    if (is_ours(&KmsOutput::crtc, crtcs[i]) || !card_.IsLit(crtcs[i])) continue;
    settings_.push_back({crtcs[i], DRM_MODE_OBJECT_CRTC, "MODE_ID", 0});
    settings_.push_back({crtcs[i], DRM_MODE_OBJECT_CRTC, "ACTIVE", 0});
    if (planes[i] == 0) continue;
    settings_.push_back({planes[i], DRM_MODE_OBJECT_PLANE, "FB_ID", 0});
    settings_.push_back({planes[i], DRM_MODE_OBJECT_PLANE, "CRTC_ID", 0});
  }
}

Result<ports::Flip> KmsScreen::ReadFlip() {
  while (const auto flip = card_.ReadFlip())
    if (flip->token == TokenOf(frame_)) TakeFlip(*flip);
  if (!shown_ || Owes()) return Fail(std::errc::resource_unavailable_try_again, "read a flip of the screen");
  if (!std::exchange(alone_, true)) RemoveOldFramebuffers();
  pictures_->ReleasePrevious();
  const Panel* const first = First();
  const Duration period = PeriodOf((first == nullptr ? panels_.front() : *first).at.output.chosen.mode);
  return ports::Flip{*std::exchange(shown_, std::nullopt), frame_, period};
}

void KmsScreen::TakeFlip(const KmsFlip& flip) {
  for (Panel& panel : panels_) {
    if (panel.at.output.crtc != flip.crtc || !panel.flips) continue;
    panel.flips = false;
    panel.light = Light::kLit;
    if (!shown_ || &panel == First()) shown_ = flip.at;
  }
}

KmsScreen::Panel* KmsScreen::First() {
  const auto first = std::ranges::find_if(panels_, [](const Panel& p) { return p.light != Light::kDark; });
  return first == panels_.end() ? nullptr : &*first;
}

bool KmsScreen::Owes() const {
  return std::ranges::any_of(panels_, [](const Panel& panel) { return panel.flips; });
}

// Only now: removing the picture that is shown blanks the screen.
void KmsScreen::RemoveOldFramebuffers() {
  for (const std::uint32_t framebuffer : card_.Framebuffers())
    if (!pictures_->Made(framebuffer)) card_.Remove(framebuffer);
}

}  // namespace kaori::scanout
