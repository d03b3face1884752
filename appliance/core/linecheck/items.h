// What a line check looks at: all that the show uses, and nothing else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "appliance/core/board/line_check.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/show/show.h"

namespace kaori::linecheck {

// Fills in the items, none of them seen: controls that the roles name, on the devices from which the roles
// are played now (`role_devices`, as performance::State has them; a role that nobody plays needs no control);
// buttons that call something on either sheet, and their lamps; switches that are wired; the keyboard where
// there is or was one; lip camera, microphone and loudspeaker; `screens` screens, one at least. Each stands
// once, whoever uses it. Pure.
board::LineCheck ItemsFor(const show::Show& show, std::span<const std::uint8_t> role_devices,
                          const board::Snapshot& board, std::size_t screens);

// So many bits of View::screens are looked at: more screens than a box drives.
inline constexpr std::size_t kMostScreens = 8;

}  // namespace kaori::linecheck
