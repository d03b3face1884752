// Eight quadrature encoders, decoded look by look.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "firmware/wire/dial_box.h"

namespace kaori::surface {

// The lines of all dials as one look sees them: bit 2n is line A of dial n, bit 2n + 1 its line B.
using DialLines = std::uint16_t;

// Counts every edge of both lines. Nothing is debounced: a contact that chatters on one line goes one count
// forth and one back. A dial of which both lines changed between two looks has gone two counts, and nobody
// knows which way: such a double step is counted as one and moves nothing.
//
// Look is called by one side, an interrupt perhaps; what the other side reads is written by plain stores of
// single words, so no lock is needed, and no read-modify-write, which this core does not have.
class Dials {
 public:
  // The looking side. The first look only learns where the lines stand.
  void Look(DialLines lines);

  // Any side. Counts since the power came, clockwise is positive; wraps at 32 bits.
  std::uint32_t position(std::size_t dial) const {
    return dials_[dial].position.load(std::memory_order_relaxed);
  }
  // Changes with every count of any dial: who has seen this number has seen the positions that led to it.
  std::uint32_t steps() const { return steps_.load(std::memory_order_acquire); }
  // Of all dials since the power came.
  std::uint32_t double_steps() const { return double_steps_.load(std::memory_order_relaxed); }

 private:
  // One dial. An object of its own, for std::atomic cannot be copied and an array of them starts at 0.
  struct Dial {
    std::atomic<std::uint32_t> position{0};
  };
  void Step(std::size_t dial, unsigned before, unsigned now);

  bool looked_ = false;
  DialLines before_ = 0;
  std::array<Dial, wire::kDials> dials_{};
  std::atomic<std::uint32_t> steps_{0};
  std::atomic<std::uint32_t> double_steps_{0};
};

}  // namespace kaori::surface
