#include "firmware/surface/buttons.h"

#include <cstddef>

namespace kaori::surface {

std::uint32_t Buttons::Look(std::uint32_t closed) {
  const std::uint32_t contradicted = closed ^ pressed_;
  // Adds one to the counter of each switch that contradicts, and clears the others; bits in which the counter
  // then is another number than the two that are waited for drop out.
  std::uint32_t carry = contradicted;
  std::uint32_t at_press = contradicted & ~pressed_;
  std::uint32_t at_release = contradicted & pressed_;
  for (std::size_t bit = 0; bit < counts_.size(); ++bit) {
    const std::uint32_t sum = (counts_[bit] ^ carry) & contradicted;
    carry &= counts_[bit];
    counts_[bit] = sum;
    at_press &= (kLooksToPress >> bit & 1U) != 0 ? sum : ~sum;
    at_release &= (kLooksToRelease >> bit & 1U) != 0 ? sum : ~sum;
  }
  const std::uint32_t flipped = at_press | at_release;
  pressed_ ^= flipped;
  for (std::uint32_t& bits : counts_) bits &= ~flipped;
  return pressed_;
}

}  // namespace kaori::surface
