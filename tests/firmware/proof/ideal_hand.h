// Operators whose every movement is known: what a surface says is compared with what they did. No operating system, so that
// the same proofs run on the host and on a Cortex-M.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/surface/dials.h"

namespace kaori::proof {

// The same numbers on every machine (Marsaglia's xorshift32).
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : state_(seed == 0 ? 1 : seed) {}
  std::uint32_t Throw() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }
  // 0 .. below - 1.
  std::uint32_t Throw(std::uint32_t below) { return Throw() % below; }
  bool OneIn(std::uint32_t chances) { return Throw(chances) == 0; }

 private:
  std::uint32_t state_;
};

// Turns eight dials by true quadrature: the angle alone is the truth, and the lines follow from it.
class DialHand {
 public:
  // Turns one dial by some counts, clockwise positive.
  void Turn(std::size_t dial, std::int32_t counts) { angles_[dial] += static_cast<std::uint32_t>(counts); }
  std::uint32_t angle(std::size_t dial) const { return angles_[dial]; }
  surface::DialLines lines() const {
    unsigned lines = 0;
    for (std::size_t dial = 0; dial < angles_.size(); ++dial) {
      // A is high in the second and the third quarter of a cycle, B a quarter later.
      const std::uint32_t quarter = angles_[dial] % 4;
      const unsigned a = quarter == 1 || quarter == 2 ? 1 : 0;
      const unsigned b = quarter == 2 || quarter == 3 ? 1 : 0;
      lines |= (a | b << 1) << (2 * dial);
    }
    return static_cast<surface::DialLines>(lines);
  }

 private:
  std::array<std::uint32_t, wire::kDials> angles_{};
};

// A switch that trembles for some looks whenever it is pushed or let go, and a dimmer beside its cable.
class BouncingSwitch {
 public:
  void Set(bool closed, std::uint32_t bouncing_looks) {
    closed_ = closed;
    bouncing_looks_ = bouncing_looks;
  }
  bool settled() const { return bouncing_looks_ == 0; }
  // What a look sees.
  bool Look(Dice& dice) {
    if (bouncing_looks_ == 0) return closed_;
    --bouncing_looks_;
    return dice.OneIn(2);
  }

 private:
  bool closed_ = false;
  std::uint32_t bouncing_looks_ = 0;
};

}  // namespace kaori::proof
