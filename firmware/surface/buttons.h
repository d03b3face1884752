// Debounces 32 switches at once.
#pragma once

#include <array>
#include <cstdint>

namespace kaori::surface {

// A switch is pressed after three looks in a row that see it closed, and released after twenty that see it
// open. At 4000 looks a second that is 0.75 ms and 5 ms: nearly eager, and deaf to a spike that a dimmer
// sends through the cable. One side.
class Buttons {
 public:
  static constexpr unsigned kLooksToPress = 3;
  static constexpr unsigned kLooksToRelease = 20;

  // Bit n of `closed`: switch n is closed at this look. Returns what is pressed.
  std::uint32_t Look(std::uint32_t closed);
  std::uint32_t pressed() const { return pressed_; }

 private:
  // Bit n of counts_[i] is bit i of switch n's counter: how many looks in a row contradicted what it is. 32
  // counters are counted up together (a vertical counter).
  std::array<std::uint32_t, 5> counts_{};
  std::uint32_t pressed_ = 0;
};

}  // namespace kaori::surface
