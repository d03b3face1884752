#include "appliance/programs/input/surface_section.h"

#include <algorithm>

#include "appliance/core/board/press_log.h"

namespace kaori::input {

using board::SourceState;

// Goes on from the board. Whose the held buttons are is not known any more: they count as the first device's
// until it confirms or releases them.
SurfaceSection::SurfaceSection(const board::Board& board, board::Writer<board::Surface> writer,
                               int counts_per_turn, std::size_t devices)
    : writer_(std::move(writer)), surface_(board.Read<board::Surface>()), devices_(devices) {
  surface_.value.counts_per_turn = counts_per_turn;
  devices_.front().buttons.down = {surface_.value.buttons_down};
}

// One device that is there makes the section live, however many are not.
void SurfaceSection::Plug(std::size_t device, Time now) {
  devices_[device].buttons.Plug();
  devices_[device].is_plugged = true;
  surface_.at = now;
  surface_.source = SourceState::kLive;
  Write();
}

// A section that was never live stays absent: there never was a box. A device that never came changes nothing
// for the others, but for what it held before the program began.
void SurfaceSection::Unplug(std::size_t device, Time now) {
  const bool held = devices_[device].buttons.down[0] != 0;
  devices_[device].buttons.Release();
  const bool was_plugged = std::exchange(devices_[device].is_plugged, false);
  const bool is_last = std::ranges::none_of(devices_, &Device::is_plugged);
  if (surface_.source != SourceState::kLive || (!was_plugged && !is_last && !held)) return;
  if (is_last) surface_.source = SourceState::kStale;
  surface_.at = now;
  Write();
}

// Counts wrap, they do not overflow.
void SurfaceSection::Turn(std::size_t dial, std::int32_t counts, Time at) {
  std::int32_t& count = surface_.value.counts[dial];
  count = static_cast<std::int32_t>(static_cast<std::uint32_t>(count) + static_cast<std::uint32_t>(counts));
  surface_.at = at;
  changed_ = true;
}

// Each push goes to the log as well, with its time: counts alone do not say in which order buttons were
// pushed between two looks of a reader.
void SurfaceSection::Switch(std::size_t device, const decode::Switches<1>& now, Time at) {
  devices_[device].buttons.Accept(now, [&](std::size_t button) {
    ++surface_.value.pushes[button];
    board::Append(surface_.value.log, static_cast<std::uint32_t>(button), at);
  });
  surface_.at = at;
  changed_ = true;
}

void SurfaceSection::Release(std::size_t device) {
  devices_[device].buttons.Release();
  Write();
}

void SurfaceSection::Publish() {
  if (std::exchange(changed_, false)) Write();
}

// A button is down while any of the devices holds it.
void SurfaceSection::Write() {
  surface_.value.buttons_down = 0;
  for (const Device& device : devices_) surface_.value.buttons_down |= device.buttons.down[0];
  writer_.Write(surface_.value, surface_.at, surface_.source);
}

}  // namespace kaori::input
