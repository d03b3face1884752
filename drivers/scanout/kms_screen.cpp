#include "drivers/scanout/kms_screen.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "drivers/scanout/kms_settings.h"

namespace kaori::scanout {
namespace {

using namespace std::chrono_literals;

constexpr Duration kCheckPeriod = 250ms;  // How often connectors are checked.
constexpr Duration kGivenUp = 5s;         // A card that refused everything is tried once more after this.
constexpr Duration kLongestFlip = 2s;     // A card that takes longer has lost the frame.

// Marks our flips: those of a program that died come through the same file.
std::uint64_t TokenOf(std::uint64_t frame) {
  return std::uint64_t(::getpid()) << 32 | (frame & 0xffffffff);
}

void Refuse(const KmsOutput& output, Time now, KmsPreferences& preferences) {
  preferences.refused.push_back({output.connector, output.chosen.mode});
  preferences.refused_at = now;
}

}  // namespace

Result<std::unique_ptr<KmsScreen>> KmsScreen::Open(KmsDevice& card, const MakeSurface& make,
                                                   const Clock& clock, KmsPreferences& preferences) {
  auto outputs = FindOutputs(card, preferences);
  if (!outputs) {
    // What a card refuses may depend on a screen that has gone meanwhile.
    if (clock.now() - preferences.refused_at > kGivenUp) preferences.refused.clear();
    return tl::unexpected(outputs.error());
  }
  auto monitor = ExtractSideOutput(card, preferences.monitor_connector, *outputs);
  auto status = ExtractSideOutput(card, preferences.status_connector, *outputs);
  KmsWall wall = Arrange(std::move(*outputs));
  wall.status = std::move(status);
  wall.monitor = std::move(monitor);
  auto surface = make(wall.width_px, wall.height_px);
  if (!surface) {
    Refuse(Largest(wall), clock.now(), preferences);
    return tl::unexpected(surface.error());
  }
  return std::unique_ptr<KmsScreen>(
      new KmsScreen(card, std::move(wall), std::move(*surface), clock, preferences));
}

KmsScreen::KmsScreen(KmsDevice& card, KmsWall wall, std::unique_ptr<KmsSurface> surface, const Clock& clock,
                     KmsPreferences& preferences)
    : card_(card),
      wall_(std::move(wall)),
      surface_(std::move(surface)),
      clock_(clock),
      preferences_(preferences),
      checked_at_(clock.now()) {
  for (const KmsPanel& panel : wall_.panels) panels_.push_back({panel});
  for (const std::uint32_t connector : card_.Connectors())
    if (IsNew(connector) && card_.ConnectionOf(connector) == Connection::kConnected)
      undriven_.push_back(connector);
  constexpr std::size_t kMostSettings = 14;  // Of one screen, as AddOutputSettings adds them.
  settings_.reserve(panels_.size() * kMostSettings);
  // Where there is no memory for a display beside it, the show goes on without.
  if (wall_.status) status_display_ = KmsSideDisplay::Open(card_, *wall_.status).value_or(nullptr);
  if (wall_.monitor) monitor_display_ = KmsSideDisplay::Open(card_, *wall_.monitor).value_or(nullptr);
}

// The card itself keeps a mode for as long as it shows it.
KmsScreen::~KmsScreen() {
  for (const Panel& panel : panels_)
    if (panel.mode != 0) card_.DestroyModeBlob(panel.mode);
}

Result<ports::PixelBuffer> KmsScreen::Acquire() {
  if (gone_) return tl::unexpected(*gone_);
  const Time now = clock_.now();
  if (now - checked_at_ >= kCheckPeriod) {
    checked_at_ = now;
    if (auto checked = CheckConnectors(); !checked) return Gone(checked.error());
  }
  if (FlipIsPending() || shown_) {
    if (now - presented_at_ > kLongestFlip)
      return Gone({std::errc::no_such_device, "await a flip of the screen"});
    return Fail(std::errc::resource_unavailable_try_again, "draw for the screen");
  }
  acquired_ = true;
  return ports::PixelBuffer{wall_.width_px, wall_.height_px, ports::EglSurface{surface_->native()}};
}

tl::unexpected<Error> KmsScreen::Gone(const Error& error) {
  gone_ = error;
  return tl::unexpected(error);
}

Result<void> KmsScreen::Present(std::uint64_t frame) {
  if (gone_) return tl::unexpected(*gone_);
  if (!std::exchange(acquired_, false)) return FailInput("present without a buffer");
  const auto framebuffer = surface_->LockFront();
  if (!framebuffer) {
    if (framebuffer.error().cause != std::errc::io_error) Refuse(Largest(wall_), clock_.now(), preferences_);
    return tl::unexpected(framebuffer.error());
  }
  // Before the commit: its token is made of the frame's number.
  frame_ = frame;
  const Time now = clock_.now();
  if (auto shown = Commit(*framebuffer, now); !shown)
    return tl::unexpected(Blame(shown.error(), *framebuffer, now));
  presented_at_ = clock_.now();
  for (Panel& panel : panels_) {
    panel.flip_pending = panel.state != PanelState::kUnplugged;
    if (!panel.at.output.link_is_bad || !IsToBeSetUp(panel, now)) continue;
    panel.at.output.link_is_bad = false;
    panel.linked_at = now;
  }
  return {};
}

// A screen that is shown already needs the new framebuffer alone.
Result<void> KmsScreen::Commit(std::uint32_t framebuffer, Time now) {
  settings_.clear();
  bool sets_modes = false;
  if (!others_removed_) AddOthersOff();
  for (Panel& panel : panels_) {
    if (panel.state == PanelState::kUnplugged) continue;
    if (!IsToBeSetUp(panel, now)) {
      settings_.push_back({panel.at.output.plane, DRM_MODE_OBJECT_PLANE, "FB_ID", framebuffer});
      continue;
    }
    if (auto added = AddPanel(panel, framebuffer); !added) return added;
    sets_modes = true;
  }
  return card_.Commit(settings_, TokenOf(frame_), sets_modes);
}

bool KmsScreen::CouldShow(Panel& panel, std::uint32_t framebuffer) {
  settings_.clear();
  return AddPanel(panel, framebuffer) && card_.TestCommit(settings_);
}

// Finds the screen whose mode the card refused, by a test commit for each new screen alone, and notes the
// refusal. Where the card would accept each alone they are too many together, and the last new one gives way.
Error KmsScreen::Blame(const Error& error, std::uint32_t framebuffer, Time now) {
  if (error.cause == std::errc::device_or_resource_busy || error.cause == std::errc::permission_denied)
    return error;
  const Panel* blamed = nullptr;
  bool alone = false;
  for (Panel& panel : panels_) {
    if (!IsToBeSetUp(panel, now) || alone) continue;
    alone = !CouldShow(panel, framebuffer);
    blamed = &panel;
  }
  if (blamed == nullptr) return error;
  Refuse(blamed->at.output, now, preferences_);
  return {error.cause,
          "show " + ports::Describe(PortOutput(blamed->at.output, ports::OutputState::kShowsPicture))};
}

Result<void> KmsScreen::AddPanel(Panel& panel, std::uint32_t framebuffer) {
  const KmsOutput& output = panel.at.output;
  if (panel.mode == 0) {
    const auto blob = card_.CreateModeBlob(output.chosen.mode);
    if (!blob) return tl::unexpected(blob.error());
    panel.mode = *blob;
  }
  AddOutputSettings(output, panel.mode, {framebuffer, panel.at.x_px, panel.at.y_px}, settings_);
  return {};
}

// Turns off what an earlier program showed on connectors that are not ours: its CRTC may be needed.
void KmsScreen::AddOthersOff() {
  // Whether an output of ours, or a display beside them, has this object.
  const auto is_ours = [this](std::uint32_t KmsOutput::*part, std::uint32_t id) {
    const auto has = [&](const auto& display) { return display && display->output().*part == id; };
    return has(status_display_) || has(monitor_display_) ||
           std::ranges::any_of(panels_, [&](const Panel& p) { return p.at.output.*part == id; });
  };
  for (const std::uint32_t connector : card_.Connectors())
    if (!is_ours(&KmsOutput::connector, connector))
      settings_.push_back({connector, DRM_MODE_OBJECT_CONNECTOR, "CRTC_ID", 0});
  const auto crtcs = card_.Crtcs();
  const auto planes = PlanesOf(card_, crtcs.size());
  for (std::size_t i = 0; i < crtcs.size(); ++i) {
    if (!is_ours(&KmsOutput::crtc, crtcs[i]) && card_.IsActive(crtcs[i]))
      AddCrtcOff(crtcs[i], planes[i], settings_);
  }
}

Result<ports::Flip> KmsScreen::ReadFlip() {
  if (gone_) return tl::unexpected(*gone_);
  // Flips of an earlier frame, or of a program that died, have another token.
  while (const auto flip = card_.ReadFlip())
    if (flip->token == TokenOf(frame_)) HandleFlip(*flip);
  if (!shown_ || FlipIsPending())
    return Fail(std::errc::resource_unavailable_try_again, "read a flip of the screen");
  if (!std::exchange(others_removed_, true)) RemoveOldFramebuffers();
  surface_->ReleasePrevious();
  const Panel* const first = First();
  const Duration period = PeriodOf((first == nullptr ? panels_.front() : *first).at.output.chosen.mode);
  return ports::Flip{*std::exchange(shown_, std::nullopt), frame_, period};
}

void KmsScreen::HandleFlip(const KmsFlip& flip) {
  for (Panel& panel : panels_) {
    if (panel.at.output.crtc != flip.crtc || !panel.flip_pending) continue;
    panel.flip_pending = false;
    panel.state = PanelState::kShown;
    if (!shown_ || &panel == First()) shown_ = flip.at;
  }
}

KmsScreen::Panel* KmsScreen::First() {
  const auto first =
      std::ranges::find_if(panels_, [](const Panel& p) { return p.state != PanelState::kUnplugged; });
  return first == panels_.end() ? nullptr : &*first;
}

bool KmsScreen::FlipIsPending() const {
  return std::ranges::any_of(panels_, [](const Panel& panel) { return panel.flip_pending; });
}

// Only after the first flip of ours: removing the framebuffer that is shown blanks the screen.
void KmsScreen::RemoveOldFramebuffers() {
  const auto is_needed = [](const auto& display, std::uint32_t framebuffer) {
    return display && display->Needs(framebuffer);
  };
  for (const std::uint32_t framebuffer : card_.Framebuffers())
    if (!surface_->Owns(framebuffer) && !is_needed(status_display_, framebuffer) &&
        !is_needed(monitor_display_, framebuffer))
      card_.RemoveFramebuffer(framebuffer);
}

std::vector<ports::Output> KmsScreen::outputs() const {
  std::vector<ports::Output> outputs;
  for (const Panel& panel : panels_) {
    const bool plugged = panel.state != PanelState::kUnplugged;
    const auto state = plugged ? ports::OutputState::kShowsPicture : ports::OutputState::kUnplugged;
    outputs.push_back(PortOutput(panel.at.output, state));
  }
  if (status_display_)
    outputs.push_back(PortOutput(status_display_->output(), ports::OutputState::kShowsStatus));
  if (monitor_display_)
    outputs.push_back(PortOutput(monitor_display_->output(), ports::OutputState::kShowsMonitor));
  return outputs;
}

}  // namespace kaori::scanout
