// The list of shows, from which somebody at the box takes one while the service key is on.
#pragma once

#include <cstdint>

#include "drivers/base/clock.h"

namespace kaori::board {

//   writer   kaori-shows, 10 times a second and more, also while it tries a show
//   readers  kaori-stage at each frame: what is pressed while the list is open is not the show's
//   stale    never written so: who has been silent for kMenuSilence has ended, and the list with it
struct ShowsMenu {
  static constexpr const char* kName = "shows_menu";
  std::uint32_t open = 0;  // 1: keys, buttons and GO take something from the list.
};

// It has the lowest priority of all programs: beside a face that wants all processors it writes late.
inline constexpr Duration kMenuSilence = std::chrono::seconds(2);

}  // namespace kaori::board
