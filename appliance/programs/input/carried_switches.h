// Switches as they stand on the board, carried on over re-plugs and over restarts of the program.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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

  void Accept(const decode::Switches<kWords>& now) {
    for (std::size_t n = 0; n < pushes.size(); ++n) {
      const bool carried = !fresh_ && ((down[n / 32] & now.down[n / 32]) >> (n % 32) & 1U) != 0;
      const std::uint32_t more = now.pushes[n] - seen_[n];
      pushes[n] += carried && more > 0 ? more - 1 : more;
    }
    seen_ = now.pushes;
    down = now.down;
    fresh_ = true;
  }

  void Release() { down = {}; }

  Down down{};
  Pushes pushes{};

 private:
  Pushes seen_{};
  bool fresh_ = false;
};

}  // namespace kaori::input
