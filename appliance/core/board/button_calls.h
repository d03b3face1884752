// What buttons call, by numbers that find pictures.
//
// kaori-input knows no show and reads no pack: a picture lies in a folder in memory under the number of its call, and
// the number of each button stands here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kaori::board {

// What the buttons of the control surface call, for surfaces that have pictures on their keys.
//   writer   kaori-stage, when it starts
//   readers  kaori-input, which shows the picture of each call (roles::SumOfCall); ShowNow has the sheet
//   stale    never written so
struct ButtonCalls {
  static constexpr const char* kName = "button_calls";
  static constexpr std::size_t kSheets = 2, kButtons = 32;
  // By sheet and button, from 0: a number of what is called, which differs from show to show; 0: nothing that
  // could have a picture.
  std::array<std::array<std::uint64_t, kButtons>, kSheets> sums{};
};

}  // namespace kaori::board
