// Switches as they stand on the board, carried on over re-plugs and over restarts of the program.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "drivers/decode/switches.h"

namespace kaori::input {

// A decoder counts pushes from 0; the board counts them since it began. What was held when the program died,
// and still is when it is back, was pushed once and not twice.
template <std::size_t kWords>
class CarriedSwitches {
 public:
  using Down = std::array<std::uint32_t, kWords>;
  using Pushes = std::array<std::uint32_t, kWords * 32>;

  // Another decoder begins at 0.
  void Plug() {
    seen_ = {};
    fresh_ = false;
  }

  // Calls `pressed(n)` for each switch n that went down with these reports, with `down` as it is now.
  template <class Pressed>
  void Accept(const decode::Switches<kWords>& now, Pressed pressed) {
    const Down before = std::exchange(down, now.down);
    for (std::size_t n = 0; n < pushes.size(); ++n) {
      const bool carried = !fresh_ && ((before[n / 32] & now.down[n / 32]) >> (n % 32) & 1U) != 0;
      const std::uint32_t counted = now.pushes[n] - seen_[n];
      const std::uint32_t more = carried && counted > 0 ? counted - 1 : counted;
      pushes[n] += more;
      for (std::uint32_t i = 0; i < more; ++i) pressed(n);
    }
    seen_ = now.pushes;
    fresh_ = true;
  }
  void Accept(const decode::Switches<kWords>& now) {
    Accept(now, [](std::size_t) {});
  }

  void Release() { down = {}; }

  Down down{};
  Pushes pushes{};

 private:
  Pushes seen_{};
  bool fresh_ = false;
};

}  // namespace kaori::input
