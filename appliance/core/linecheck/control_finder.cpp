#include "appliance/core/linecheck/control_finder.h"

#include <algorithm>
#include <utility>

#include "appliance/core/linecheck/reading.h"

namespace kaori::linecheck {
namespace {

using board::CheckedItem;
using board::CheckedKind;
using namespace std::chrono_literals;

constexpr Duration kRest = 300ms;
constexpr Duration kLooksFor = 500ms;
constexpr Duration kLongestMovement = 2s;  // What takes longer to go so far creeps.
constexpr Duration kRestlessAfter = 2s;
constexpr float kMeant = 0.3F;
// Of the furthest way: nobody pushes one axis without moving the other a little.
constexpr float kAlike = 0.6F;
constexpr float kWayOfDial = 0.5F;  // Turns, in place of an end.

// How far it went from where it rested; 1 is the way from a middle to an end.
float FarOf(const CheckedItem& item, const Way& way) {
  return (way.high() - way.low()) / (item.kind == CheckedKind::kDial ? kWayOfDial : 1.0F);
}

}  // namespace

void ControlFinder::Begin(const board::Snapshot& board, Time now) {
  *this = {};
  counts_ = board.surface.value.counts;
  changed_at_ = now;
  std::size_t n = 0;
  for (std::uint32_t stick = 0; stick < 2; ++stick)
    for (std::uint32_t axis = 0; axis < kAxes; ++axis)
      candidates_[n++].item = {.kind = CheckedKind::kAxis, .device = stick, .number = axis};
  for (std::uint32_t dial = 0; dial < kDials; ++dial)
    candidates_[n++].item = {.kind = CheckedKind::kDial,
                             .device = static_cast<std::uint32_t>(show::Device::kDialBox),
                             .number = dial};
  for (Candidate& candidate : candidates_) Wait(candidate, WayNow(candidate.item, board, counts_), now);
}

void ControlFinder::Wait(Candidate& candidate, float at, Time now) const {
  candidate.way.Begin(at, now);
  candidate.rested = false;
  candidate.waits_since = now;
  candidate.left_at.reset();
}

void ControlFinder::Look(const board::Snapshot& board, Time now) {
  for (Candidate& candidate : candidates_) Follow(candidate, board, now);
  const auto is_meant = [](const Candidate& one) { return one.rested && FarOf(one.item, one.way) >= kMeant; };
  if (!decides_at_ && std::ranges::any_of(candidates_, is_meant)) decides_at_ = now + kLooksFor;
  if (decides_at_ && now >= *decides_at_) Decide(now);
}

// A device that is not there waits. One that rests where it is begins there anew, so that only one movement
// counts, and so does one that has not gone far enough in the time that a person takes.
void ControlFinder::Follow(Candidate& candidate, const board::Snapshot& board, Time now) const {
  const float at = WayNow(candidate.item, board, counts_);
  if (SourceOfWay(candidate.item, board) != board::SourceState::kLive) return Wait(candidate, at, now);
  Way& way = candidate.way;
  way.Follow(at, EndsOf(candidate.item, board), now);
  const bool rests = way.rests(now) >= kRest;
  if (!candidate.rested) {
    if (!rests) return;
    way.Begin(at, now);
    candidate.rested = true;
    return;
  }
  const float far = FarOf(candidate.item, way);
  if (way.rests(now) == Duration{} && !candidate.left_at) candidate.left_at = now;
  if (far >= kMeant) return;
  const bool creeps = candidate.left_at && now - *candidate.left_at >= kLongestMovement;
  if (way.noisy() || creeps) return Wait(candidate, at, now);
  if (rests && candidate.left_at) {
    way.Begin(at, now);
    candidate.left_at.reset();
  }
}

// Whatever was found, all have to rest before they count again: the way back of a spring is no movement of
// its own.
void ControlFinder::Decide(Time now) {
  decides_at_.reset();
  changed_at_ = now;
  const auto far = [](const Candidate& one) {
    return one.rested && !one.way.noisy() ? FarOf(one.item, one.way) : 0.0F;
  };
  const auto best = std::ranges::max_element(candidates_, {}, far);
  const float alike = kAlike * far(*best);
  ambiguous_ = std::ranges::any_of(candidates_,
                                   [&](const Candidate& one) { return &one != &*best && far(one) > alike; });
  if (!ambiguous_ && far(*best) >= kMeant) {
    found_ = best->item;
    found_->low = best->way.low();
    found_->high = best->way.high();
    found_->state = board::CheckedState::kSeen;
  }
  for (Candidate& candidate : candidates_)
    if (std::exchange(candidate.rested, false)) candidate.waits_since = now;
}

std::optional<CheckedItem> ControlFinder::restless(Time now) const {
  const auto found = std::ranges::find_if(candidates_, [now](const Candidate& one) {
    return !one.rested && one.way.rests(now) < kRest && now - one.waits_since >= kRestlessAfter;
  });
  return found == candidates_.end() ? std::nullopt : std::optional(found->item);
}

}  // namespace kaori::linecheck
