// What the screens' cables do while the show plays.
#include <algorithm>

#include "drivers/scanout/kms_screen.h"

namespace kaori::scanout {
namespace {

// Between two tries to train a link that fails.
constexpr Duration kRelinkPause = std::chrono::seconds(10);

}  // namespace

// The kernel knows what the last probe saw: a screen that
// is shown may have been replaced by another one since.
Result<void> KmsScreen::ProbeAll() {
  for (const std::uint32_t connector : card_.Connectors()) {
    const auto found = card_.Probe(connector);
    const auto panel =
        std::ranges::find(panels_, connector, [](const Panel& p) { return p.at.output.connector; });
    if (!found || !found->plugged) continue;
    for (KmsSideDisplay* const display : {status_display_.get(), monitor_display_.get()})
      if (display != nullptr && display->output().connector == connector)
        display->NoteLink(found->link_is_bad);
    if (panel == panels_.end()) continue;
    if (!IsAsBefore(*found, *panel))
      return Fail(std::errc::no_such_device, "keep the screens as they were: one has another mode");
    panel->at.output.link_is_bad = found->link_is_bad;
  }
  return {};
}

// Another mode of the same size would do: the part of the picture stays the same.
bool KmsScreen::IsAsBefore(const KmsConnector& connector, const Panel& panel) const {
  const auto now = ModeFor(connector, preferences_);
  const auto& before = panel.at.output.chosen.mode;
  return now && now->mode.hdisplay == before.hdisplay && now->mode.vdisplay == before.vdisplay;
}

Result<void> KmsScreen::CheckConnectors() {
  if (card_.DrainHotplug())
    if (auto probed = ProbeAll(); !probed) return probed;
  for (const std::uint32_t connector : card_.Connectors()) {
    const bool plugged = card_.ConnectionOf(connector) == Connection::kConnected;
    if (!plugged) std::erase(undriven_, connector);
    if (plugged && IsNew(connector))
      return Fail(std::errc::no_such_device, "keep the screens as they were: another one was plugged in");
  }
  for (Panel& panel : panels_)
    if (auto checked = CheckPanel(panel); !checked) return checked;
  for (KmsSideDisplay* const display : {status_display_.get(), monitor_display_.get()})
    if (display != nullptr) CheckLink(*display);
  if (First() == nullptr) return Fail(std::errc::no_such_device, "draw for the screen");
  return {};
}

void KmsScreen::CheckLink(KmsSideDisplay& display) {
  const Time now = clock_.now();
  if (!display.output().link_is_bad || (side_linked_at_ && now - *side_linked_at_ < kRelinkPause)) return;
  side_linked_at_ = now;
  display.SetUpAnew();
}

bool KmsScreen::IsNew(std::uint32_t connector) const {
  return std::ranges::find(undriven_, connector) == undriven_.end() &&
         std::ranges::none_of(panels_, [&](const Panel& p) { return p.at.output.connector == connector; });
}

Result<void> KmsScreen::CheckPanel(Panel& panel) {
  const std::uint32_t connector = panel.at.output.connector;
  const bool plugged = card_.ConnectionOf(connector) == Connection::kConnected;
  if (!plugged) {
    panel.state = PanelState::kUnplugged;
    panel.flip_pending = false;
    return {};
  }
  if (panel.state != PanelState::kUnplugged) return {};
  const auto back = card_.Probe(connector);
  if (!back || !back->plugged) return {};
  if (!IsAsBefore(*back, panel))
    return Fail(std::errc::no_such_device, "keep the screens as they were: one came back with another mode");
  panel.state = PanelState::kNew;
  panel.at.output.link_is_bad = back->link_is_bad;
  return {};
}

// A link that fails again each time would otherwise have its mode set, and all screens wait for that, all the time.
bool KmsScreen::IsToBeSetUp(const Panel& panel, Time now) const {
  if (panel.state == PanelState::kNew) return true;
  const bool is_due = !panel.linked_at || now - *panel.linked_at >= kRelinkPause;
  return panel.state == PanelState::kShown && panel.at.output.link_is_bad && is_due;
}

}  // namespace kaori::scanout
