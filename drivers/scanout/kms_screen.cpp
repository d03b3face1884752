#include "drivers/scanout/kms_screen.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "drivers/scanout/kms_settings.h"

namespace kaori::scanout {
namespace {

using namespace std::chrono_literals;

constexpr Duration kLookPeriod = 250ms;  // How often connectors are looked at.
constexpr Duration kGivenUp = 5s;        // A card that refused everything is asked once more after this.
constexpr Duration kLongestFlip = 2s;    // A card that takes longer has lost the frame.

// Whose flip an event is: a dead program's comes by through the same file, and is not ours.
std::uint64_t TokenOf(std::uint64_t frame) {
  return std::uint64_t(::getpid()) << 32 | (frame & 0xffffffff);
}

const KmsOutput& Largest(const KmsWall& wall) {
  const auto area = [](const KmsPanel& panel) {
    return int{panel.output.chosen.mode.hdisplay} * panel.output.chosen.mode.vdisplay;
  };
  return std::ranges::max_element(wall.panels, {}, area)->output;
}

void Refuse(const KmsOutput& output, Time now, KmsWishes& wishes) {
  wishes.refused.push_back({output.connector, output.chosen.mode});
  wishes.refused_at = now;
}

}  // namespace

Result<std::unique_ptr<KmsScreen>> KmsScreen::Open(KmsDevice& card, const MakePictures& make,
                                                   const Clock& clock, KmsWishes& wishes) {
  auto outputs = FindOutputs(card, wishes);
  if (!outputs) {
    if (clock.now() - wishes.refused_at > kGivenUp) wishes.refused.clear();
    return tl::unexpected(outputs.error());
  }
  auto sign = ExtractStatusOutput(card, wishes.sign, *outputs);
  KmsWall wall = Arrange(std::move(*outputs));
  wall.sign = std::move(sign);
  auto pictures = make(wall.width_px, wall.height_px);
  if (!pictures) {
    Refuse(Largest(wall), clock.now(), wishes);
    return tl::unexpected(pictures.error());
  }
  return std::unique_ptr<KmsScreen>(
      new KmsScreen(card, std::move(wall), std::move(*pictures), clock, wishes));
}

KmsScreen::KmsScreen(KmsDevice& card, KmsWall wall, std::unique_ptr<KmsPictures> pictures, const Clock& clock,
                     KmsWishes& wishes)
    : card_(card),
      wall_(std::move(wall)),
      pictures_(std::move(pictures)),
      clock_(clock),
      wishes_(wishes),
      looked_(clock.now()) {
  for (const KmsPanel& panel : wall_.panels) panels_.push_back({panel});
  for (const std::uint32_t connector : card_.Connectors())
    if (IsNewcomer(connector) && card_.PlugOf(connector) == Plug::kPlugged) seen_.push_back(connector);
  constexpr std::size_t kMostSettings = 13;  // Of one screen.
  settings_.reserve(panels_.size() * kMostSettings);
  // Where there is no memory for one, the show goes on without.
  if (wall_.sign) status_display_ = KmsStatusDisplay::Open(card_, *wall_.sign).value_or(nullptr);
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
  const auto now = ModeFor(connector, wishes_);
  const auto& before = panel.at.output.chosen.mode;
  return now && now->mode.hdisplay == before.hdisplay && now->mode.vdisplay == before.vdisplay;
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
  if (!std::exchange(acquired_, false)) return FailInput("present without a buffer");
  const auto framebuffer = pictures_->LockFront();
  if (!framebuffer) {
    if (framebuffer.error().cause != std::errc::io_error) Refuse(Largest(wall_), clock_.now(), wishes_);
    return tl::unexpected(framebuffer.error());
  }
  frame_ = frame;
  if (auto shown = Commit(*framebuffer); !shown) return tl::unexpected(Blame(shown.error(), *framebuffer));
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

bool KmsScreen::CouldShow(Panel& panel, std::uint32_t framebuffer) {
  settings_.clear();
  return AddAll(panel, framebuffer) && card_.Try(settings_);
}

// Which screen's mode it was that the card refused, it says of each alone. Where each alone would do, they
// are too much together, and the last one that is new gives way.
Error KmsScreen::Blame(const Error& error, std::uint32_t framebuffer) {
  if (error.cause == std::errc::device_or_resource_busy || error.cause == std::errc::permission_denied)
    return error;
  const Panel* blamed = nullptr;
  bool alone = false;
  for (Panel& panel : panels_) {
    if (panel.light != Light::kNew || alone) continue;
    alone = !CouldShow(panel, framebuffer);
    blamed = &panel;
  }
  if (blamed == nullptr) return error;
  Refuse(blamed->at.output, clock_.now(), wishes_);
  return {error.cause, "show " + Describe(blamed->at.output)};
}

Result<void> KmsScreen::AddAll(Panel& panel, std::uint32_t framebuffer) {
  const KmsOutput& output = panel.at.output;
  if (panel.mode == 0) {
    const auto told = card_.TellMode(output.chosen.mode);
    if (!told) return tl::unexpected(told.error());
    panel.mode = *told;
  }
  AddWhole(output, panel.mode, {framebuffer, panel.at.x_px, panel.at.y_px}, settings_);
  return {};
}

// What an earlier program showed elsewhere, on a screen that has gone since, ends: its CRTC may be needed.
void KmsScreen::AddOthersOff() {
  const auto is_ours = [this](std::uint32_t KmsOutput::*part, std::uint32_t id) {
    return (status_display_ && status_display_->output().*part == id) ||
           std::ranges::any_of(panels_, [&](const Panel& p) { return p.at.output.*part == id; });
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
    if (flip->token == TokenOf(frame_)) HandleFlip(*flip);
  if (!shown_ || Owes()) return Fail(std::errc::resource_unavailable_try_again, "read a flip of the screen");
  if (!std::exchange(alone_, true)) RemoveOldFramebuffers();
  pictures_->ReleasePrevious();
  const Panel* const first = First();
  const Duration period = PeriodOf((first == nullptr ? panels_.front() : *first).at.output.chosen.mode);
  return ports::Flip{*std::exchange(shown_, std::nullopt), frame_, period};
}

void KmsScreen::HandleFlip(const KmsFlip& flip) {
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
    if (!pictures_->Made(framebuffer) && !(status_display_ && status_display_->Needs(framebuffer))) card_.Remove(framebuffer);
}

std::string KmsScreen::Words() const {
  std::string words;
  for (const Panel& panel : panels_)
    words += Describe(panel.at.output) + (panel.light == Light::kDark ? ", pulled\n" : "\n");
  if (status_display_) words += Describe(status_display_->output()) + ", shows the status\n";
  return words;
}

}  // namespace kaori::scanout
