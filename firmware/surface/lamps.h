// 32 lamps with one brightness.
#pragma once

#include <cstdint>

namespace kaori::surface {

// A period has 15 ticks: brightness b lights the lamps in b of them, in runs of 8, 4, 2 and 1 as the bits of
// b say. At 4000 ticks a second a period is 3.75 ms (267 Hz), which no eye and no camera's picture of a face
// sees. One side.
class Lamps {
 public:
  static constexpr std::uint8_t kBrightest = 15;

  void set_lit(std::uint32_t lit) { lit_ = lit; }
  void set_brightness(std::uint8_t brightness) {
    brightness_ = brightness < kBrightest ? brightness : kBrightest;
  }
  std::uint32_t lit() const { return lit_; }
  std::uint8_t brightness() const { return brightness_; }

  // What the lamps' outputs show during the next tick: bit n is lamp n.
  std::uint32_t Tick();

 private:
  std::uint32_t lit_ = 0;
  std::uint8_t brightness_ = kBrightest;
  std::uint8_t tick_ = 0;
};

}  // namespace kaori::surface
