#include "appliance/core/performance/controls.h"

#include <algorithm>
#include <cmath>

#include "appliance/core/performance/stick_way.h"

namespace kaori::performance {
namespace {

// So near, as a part of the map's range, a control has met its level; within kSameMovement_s after it took
// it, it keeps it even where it moved on faster than that.
constexpr float kMeets = 3.0F / 128;
constexpr float kSameMovement_s = 0.05F;
constexpr float kAtTheEnd = 1e-6F;  // Of a way that is left: nothing to divide by.

}  // namespace

// Of a control that the device does not have: 0, as if nobody touched it.
float Controls::WayOf(const Run& run, const show::RoleMap& map) const {
  if (!IsOn(run.role, map.control) || show::Turns(map.control)) return 0;
  return WayOn(board_.sticks[state_.role_devices[run.role]].value, map.control);
}

// A whole turn is the whole range, whatever the encoder counts. A box that says 0 counts a turn does not
// divide by it.
float Controls::TurnedBy(const Run& run, const show::RoleMap& map) const {
  if (!show::Turns(map.control) || !IsOn(run.role, map.control)) return 0;
  const auto per_turn = static_cast<float>(std::max(1, board_.surface.value.counts_per_turn));
  return static_cast<float>(events_.turned[map.dial]) / per_turn * (map.to - map.from);
}

// Only sticks are asked: a dial has no way that must have been seen before its movements count.
bool Controls::IsLive(std::uint8_t role) const {
  const std::uint8_t device = state_.role_devices[role];
  return device < board_.sticks.size() && board_.sticks[device].source == board::SourceState::kLive;
}

bool Controls::IsOn(std::uint8_t role, show::Control control) const {
  const std::uint8_t device = state_.role_devices[role];
  return device < kNoDevice && show::Has(static_cast<show::Device>(device), control);
}

// Dials are not in it: what they have turned is in the level itself.
float SumOf(const Run& run) {
  float sum = 0;
  for (std::size_t i = 0; i < run.maps.size(); ++i)
    if (!show::Turns(run.maps[i].control)) sum += run.now[i].value;
  return sum;
}

// A control that springs back always comes from its middle, and need not meet anything.
bool MeetsFirst(const show::RoleMap& map) {
  return show::StaysPut(map.control) && map.takeover != show::Takeover::kJump;
}

// True where the control has met the level `here` on its way from `from` to `to`: it came near, or passed it
// between two frames, or it took it a moment ago and still moves.
bool PickUp(const show::RoleMap& map, MapNow& now, float here, float from, float to) {
  const float meets = kMeets * std::abs(map.to - map.from);
  const bool met = std::abs(here - from) <= meets || std::abs(here - to) <= meets;
  const bool passed = (here - from) * (here - to) < 0;
  if (!met && !passed && now.untaken_s > kSameMovement_s) return false;
  now.untaken_s = 0;
  now.value = to;
  return true;
}

// The rest of the control's way is stretched over the rest of the level's, so that both reach the end
// together and the level never moves against the control.
float Scaled(const show::RoleMap& map, float here, float from, float to) {
  const float low = std::min(map.from, map.to), high = std::max(map.from, map.to);
  const float end = to > from ? high : low;
  const float inside = std::clamp(here, low, high);
  if (std::abs(end - from) <= kAtTheEnd) return inside;
  return std::clamp(inside + (to - from) * (end - inside) / (end - from), low, high);
}

}  // namespace kaori::performance
