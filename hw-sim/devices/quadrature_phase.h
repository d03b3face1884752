// How the two lines of an encoder go, for whoever turns one by hand: in the guest, or at a machine's own lines.
#pragma once

#include <array>

namespace kaori::sim {

// Of the two lines of one dial: 0 is A, 1 is B.
struct QuadratureEdge {
  int line = 0;
  bool is_high = false;
};

// Where one encoder stands in its cycle of four edges. Begins where pull-ups leave it: both lines are high. Pure.
class QuadraturePhase {
 public:
  // One edge on; clockwise, where `direction` is positive, A comes first. Gives the line that changes, and how it stands then.
  QuadratureEdge Step(int direction) {
    const unsigned before = kLevels[phase_];
    phase_ = (phase_ + (direction > 0 ? 1U : 3U)) % 4;
    const unsigned changed = before ^ kLevels[phase_];
    return {changed == 0b01 ? 0 : 1, (kLevels[phase_] & changed) != 0};
  }

 private:
  static constexpr std::array<unsigned, 4> kLevels{0b00, 0b01, 0b11, 0b10};  // Bit 0 is A, bit 1 is B.
  unsigned phase_ = 2;
};

}  // namespace kaori::sim
