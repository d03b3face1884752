// The simulated panel of switches on GPIO lines, and its tally lamp.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>

#include "hw-sim/devices/operator_action.h"

namespace kaori::sim {

// The input lines in the order in which the box expects them (appliance/core/board/lines.h).
inline constexpr std::array<std::string_view, 6> kLineNames{"go",       "blackout", "service",
                                                            "presence", "back",     "panic"};

// Switches without bounce: a contact that chatters is made by two calls. Lines 0, 4 and 5 (push buttons)
// and 1 to 3 (switches that stay) differ only for whoever operates them. One thread.
class LinePanel {
 public:
  // The numbers of the lines.
  static constexpr int kInputs = static_cast<int>(kLineNames.size());
  static constexpr int kOutputs = 1;  // Line 0: the tally lamp.

  // An input that changed, and when.
  struct Edge {
    // The context's clock, when the switch moved.
    Time at{};
    // 0 .. 5, as kLineNames has them.
    int line = 0;
    // The switch is on.
    bool closed = false;
  };

  // Borrows the context.
  explicit LinePanel(const DeviceContext& context) : context_(context) {}

  // Test's side. Numbers outside of 0 to 5 are ignored.
  void Close(int line) { Set(line, true); }  // The switch is on,
  void Open(int line) { Set(line, false); }  // and off.
  bool tally() const { return tally_; }      // The lamp is lit.

  // Appliance's side. Bit n: the switch of line n is closed.
  std::uint32_t closed() const { return closed_; }
  // The oldest edge that has not been asked for; nothing: none waits. Edges are
  // stamped when the switch moved. 1024 wait at most: beyond them the oldest is lost that is not the newest
  // of its line, so that pushes are lost and every line ends at its level.
  std::optional<Edge> NextEdge();
  // A host came: it reads the levels, and older edges are gone. A host that left drives nothing.
  void HostCame() { edges_.clear(); }
  // The lamp goes dark: nobody drives it.
  void HostLeft() { tally_ = false; }
  // Drives an output; others than 0 are ignored, as no lamp is wired to them.
  void Drive(int output, bool active);

 private:
  // Moves a switch, and keeps the edge for the host.
  void Set(int line, bool closed);
  // Drops the oldest edge that is not the newest of its line.
  void DropEdge();

  const DeviceContext& context_;
  // Bit n: the switch of line n is closed.
  std::uint32_t closed_ = 0;
  // The oldest first.
  std::deque<Edge> edges_;
  // The lamp is lit: output 0 is driven.
  bool tally_ = false;
};

}  // namespace kaori::sim
