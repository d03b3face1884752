// Turns of dials whose two lines each are told by edges with sequence numbers.
#pragma once

#include <array>
#include <cstdint>

#include "drivers/base/clock.h"
#include "drivers/decode/dial_box.h"

namespace kaori::decode {

// An edge of one line, as Linux tells it (GPIO uAPI v2).
struct DialEdge {
  Time at{};                   // CLOCK_MONOTONIC, when the interrupt came.
  std::uint32_t line = 0;      // Channel A of dial n is line 2 n, channel B line 2 n + 1.
  bool active = false;         // After the edge.
  std::uint32_t sequence = 0;  // Of all lines together; wraps.
};

// Every edge counts, and what is missing never becomes a turn. A gap in the numbers means that the kernel
// dropped edges: nothing is known then until somebody has read the levels, and edges of before that moment
// are passed over. Pure; one thread.
class QuadratureDials {
 public:
  // `levels`: bit n is line n. Whatever they are, this is where the dials stand.
  explicit QuadratureDials(std::uint32_t levels) : levels_(levels) {}

  // Returns whether a dial turned.
  bool Accept(const DialEdge& edge);
  // Edges are missing: the levels are to be read, and told by Resume.
  bool needs_levels() const { return needs_levels_; }
  // `levels` were read at `at`, or right after it.
  void Resume(std::uint32_t levels, Time at);

  // Clockwise (A before B) is positive; four counts a cycle; they wrap.
  const std::array<std::int32_t, kMaxDials>& counts() const { return counts_; }
  std::uint32_t gaps() const { return gaps_; }

 private:
  std::uint32_t levels_;
  bool began_ = false;
  std::uint32_t last_sequence_ = 0;
  bool needs_levels_ = false;
  Time resumed_at_{};
  std::uint32_t gaps_ = 0;
  std::array<std::int32_t, kMaxDials> counts_{};
};

}  // namespace kaori::decode
