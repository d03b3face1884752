// Where the axes and dials of the devices stand, as a line check reads them.
#pragma once

#include <array>
#include <cstdint>

#include "appliance/core/board/line_check.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/linecheck/trace.h"
#include "appliance/core/show/roles.h"

namespace kaori::linecheck {

// The control of an axis; of nothing else.
inline show::Control ControlOf(const board::CheckedItem& item) {
  return static_cast<show::Control>(item.number);
}

// How the device of an axis or a dial stands. Pure, as all of this file.
board::SourceState SourceOfWay(const board::CheckedItem& item, const board::Snapshot& board);

// Where an axis stands, -1..1 or 0..1; how many turns a dial is away from `began`, the counts of all dials at
// some time before. Counts wrap; their difference does not, over the turns that a person makes.
float WayNow(const board::CheckedItem& item, const board::Snapshot& board,
             const std::array<std::int32_t, 8>& began);

// The ends of that way, and how little of it is no movement.
Way::Ends EndsOf(const board::CheckedItem& item, const board::Snapshot& board);

}  // namespace kaori::linecheck
