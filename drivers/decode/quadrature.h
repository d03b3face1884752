// Turns of dials whose two lines each are told by edges with sequence numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "drivers/base/clock.h"
#include "drivers/decode/dial_box.h"

namespace kaori::decode {

// An edge of one line, as Linux tells it (GPIO uAPI v2).
struct DialEdge {
  Time at{};                   // CLOCK_MONOTONIC, when the interrupt came.
  std::uint32_t line = 0;      // Channel A of dial n is line 2 n, channel B line 2 n + 1.
  bool active = false;         // After the edge.
  std::uint32_t sequence = 0;  // Of all lines together, from 1; wraps.
};

// Every edge counts, and what is missing never becomes a turn. Linux numbers an edge in its interrupt and passes it on in a
// thread of its line (gpiolib-cdev.c, edge_irq_handler and edge_irq_thread), so that on several processors edges overtake
// each other: those that come early wait for the one before. A number that does not come means that the kernel
// dropped edges: nothing is known then until somebody has read the levels, and edges of before that moment
// are passed over. Pure; one thread.
class QuadratureDials {
 public:
  // More edges than that before their turn, or one of them for so long: what they wait for is lost.
  static constexpr std::size_t kMostEarly = 16;
  static constexpr Duration kLongestEarly = std::chrono::milliseconds(50);

  // `levels`: bit n is line n. Whatever they are, this is where the dials stand.
  explicit QuadratureDials(std::uint32_t levels) : levels_(levels) {}

  // Returns whether a dial turned, by this edge or by those that waited for it.
  bool Accept(const DialEdge& edge);
  // Time goes by without an edge, by the clock of the edges. Returns needs_levels().
  bool Expire(Time now);
  // Edges are missing: the levels are to be read, and told by Resume.
  bool needs_levels() const { return needs_levels_; }
  // `levels` were read at `at`, or right after it.
  void Resume(std::uint32_t levels, Time at);

  // Clockwise (A before B) is positive; four counts a cycle; they wrap.
  const std::array<std::int32_t, kMaxDials>& counts() const { return counts_; }
  std::uint32_t gaps() const { return gaps_; }

 private:
  // Of an edge whose turn it is. Returns whether its dial turned.
  bool Apply(const DialEdge& edge);
  // What waited for no other any more. Returns whether a dial turned.
  bool Release();
  // A number is lost, and with it what waited; `sequence` was seen.
  void Lose(std::uint32_t sequence);

  std::uint32_t levels_;
  std::uint32_t next_ = 1;                                   // The number of the edge whose turn it is.
  std::array<std::optional<DialEdge>, kMostEarly> early_{};  // By their numbers, modulo the length.
  bool needs_levels_ = false;
  Time resumed_at_{};
  std::uint32_t gaps_ = 0;
  std::array<std::int32_t, kMaxDials> counts_{};
};

}  // namespace kaori::decode
