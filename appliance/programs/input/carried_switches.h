// Switches as they stand on the board, carried on over plugs of the device and over restarts of the program.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "drivers/decode/switches.h"

namespace kaori::input {

// A decoder counts pushes from 0 at each plug, and the board counts them since the board began. This class
// adds up the difference. A switch that was held when the program died, and still is when the program is
// back, was pushed once, not twice. `kWords` is the number of 32-bit words of switches. A plain value; one
// thread.
template <std::size_t kWords>
class CarriedSwitches {
 public:
  using Down = std::array<std::uint32_t, kWords>;         // Bit n % 32 of word n / 32: switch n is held.
  using Pushes = std::array<std::uint32_t, kWords * 32>;  // By switch, since the board began.

  // Prepares for the first sample of a new decoder, which counts from 0.
  void Plug() {
    seen_ = {};
    sampled_ = false;
  }

  // Adds what happened between the last sample and `now`. Calls `pressed(n)` once for each press of switch n,
  // with `down` as it is now.
  template <class Pressed>
  void Accept(const decode::Switches<kWords>& now, Pressed pressed) {
    const Down before = std::exchange(down, now.down);
    for (std::size_t n = 0; n < pushes.size(); ++n) {
      // The first sample after a plug counts each switch that it finds down as a push. Where the board
      // already has that switch down, the push is the one that was counted before.
      const bool carried = !sampled_ && ((before[n / 32] & now.down[n / 32]) >> (n % 32) & 1U) != 0;
      // Unsigned, so that the difference is right when the decoder's count wraps.
      const std::uint32_t counted = now.pushes[n] - seen_[n];
      const std::uint32_t more = carried && counted > 0 ? counted - 1 : counted;
      pushes[n] += more;
      for (std::uint32_t i = 0; i < more; ++i) pressed(n);
    }
    seen_ = now.pushes;
    sampled_ = true;
  }
  void Accept(const decode::Switches<kWords>& now) {
    Accept(now, [](std::size_t) {});
  }

  // Releases every switch; the counts stay. A switch that is down again in the next sample is pushed anew.
  void Release() { down = {}; }

  // Both are read from the board when the program starts, and written back after each sample.
  Down down{};
  Pushes pushes{};

 private:
  Pushes seen_{};         // The decoder's counts at the last sample.
  bool sampled_ = false;  // A sample arrived since the plug.
};

}  // namespace kaori::input
