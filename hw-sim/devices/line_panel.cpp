#include "hw-sim/devices/line_panel.h"

#include <algorithm>

namespace kaori::sim {
namespace {

// A host that never reads must not eat memory. The kernel's queue is far shorter.
constexpr std::size_t kMostEdges = 1024;

}  // namespace

// A line that stands so already gives no edge, as a real switch. Edges that nobody fetches are kept up to a
// limit.
void LinePanel::Set(int line, bool closed) {
  if (line < 0 || line >= kInputs) return;
  const std::uint32_t bit = 1U << static_cast<unsigned>(line);
  if (((closed_ & bit) != 0) == closed) return;
  closed_ ^= bit;
  edges_.push_back({context_.clock.now(), line, closed});
  if (edges_.size() > kMostEdges) DropEdge();
  context_.Notify({DevicePort::kLines, closed ? Verb::kPush : Verb::kRelease, line, 0, 0});
}

// There is one: edges are many more than lines.
void LinePanel::DropEdge() {
  for (auto edge = edges_.begin(); edge != edges_.end(); ++edge) {
    const auto of_line = [&](const Edge& newer) { return newer.line == edge->line; };
    if (!std::any_of(edge + 1, edges_.end(), of_line)) continue;
    edges_.erase(edge);
    return;
  }
}

std::optional<LinePanel::Edge> LinePanel::NextEdge() {
  if (edges_.empty()) return std::nullopt;
  const Edge edge = edges_.front();
  edges_.pop_front();
  return edge;
}

void LinePanel::Drive(int output, bool active) {
  if (output == 0) tally_ = active;
}

}  // namespace kaori::sim
