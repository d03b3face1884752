// The controls of roles: where they stand, what they contribute, and how one that stays where it is put takes
// a level over.
#pragma once

#include <span>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/roles.h"

namespace kaori::performance {

// The maps of one role on one level.
struct Run {
  std::uint8_t role = 0;
  show::Level level{};
  std::span<const show::RoleMap> maps;
  std::span<MapNow> now;  // As many.
};

// Calls `visit(run)` for each, in the order of the roles. Roles keep the maps of one level together
// (CheckRoles).
template <class Visit>
void ForEachRun(State& state, const show::Roles& roles, Visit visit) {
  std::size_t first = 0;
  for (std::size_t role = 0; role < roles.roles.size(); ++role) {
    const std::span<const show::RoleMap> maps(roles.roles[role].maps);
    for (std::size_t at = 0, end = 0; at < maps.size(); at = end) {
      while (end < maps.size() && maps[end].level == maps[at].level) ++end;
      visit(Run{static_cast<std::uint8_t>(role), maps[at].level, maps.subspan(at, end - at),
                std::span(state.maps).subspan(first + at, end - at)});
    }
    first += maps.size();
  }
}

// Where the controls stand in one frame, on the devices from which their roles are played. Borrows all three.
class Controls {
 public:
  Controls(const State& state, const board::Snapshot& board, const InputEvents& events)
      : state_(state), board_(board), events_(events) {}

  // 0 where the role's device has no such control, or is none.
  float WayOf(const Run& run, const show::RoleMap& map) const;
  // What a dial has turned since the last frame, as a part of the level; 0 for other controls.
  float TurnedBy(const Run& run, const show::RoleMap& map) const;
  // Whether the role's device is a stick that answers.
  bool IsLive(std::uint8_t role) const;

 private:
  bool IsOn(std::uint8_t role, show::Control control) const;

  const State& state_;
  const board::Snapshot& board_;
  const InputEvents& events_;
};

// What the controls of a run contribute together, but for its dials.
float SumOf(const Run& run);

// Whether the control waits for the level, or goes on from it, where something else has moved that.
bool MeetsFirst(const show::RoleMap& map);

// Soft take-over as Mixxx has it (engine/controls/softtakeover.cpp): the control is taken where it is within
// 3/128 of its range from the level, where it has passed it, and within 50 ms of a movement that was taken.
// `here` is the level as this control would have to say it, `from` and `to` what it said before and says now.
// True: now.value is `to`.
bool PickUp(const show::RoleMap& map, MapNow& now, float here, float from, float to);

// Where the level goes from `here` when its control goes from `from` to `to`: both reach the end of the range
// together.
float Scaled(const show::RoleMap& map, float here, float from, float to);

}  // namespace kaori::performance
