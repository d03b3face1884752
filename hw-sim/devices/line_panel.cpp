#include "hw-sim/devices/line_panel.h"

namespace kaori::sim {
namespace {

// A host that never reads must not eat memory: beyond this the oldest edges are lost, as in
// the kernel, whose queue is far shorter.
constexpr std::size_t kMostEdges = 1024;

}  // namespace

void LinePanel::Set(int line, bool closed) {
  if (line < 0 || line >= kInputs) return;
  const std::uint32_t bit = 1U << static_cast<unsigned>(line);
  if (((closed_ & bit) != 0) == closed) return;
  closed_ ^= bit;
  edges_.push_back({context_.clock.now(), line, closed});
  if (edges_.size() > kMostEdges) edges_.pop_front();
  context_.Notify({DevicePort::kLines, closed ? Verb::kPush : Verb::kRelease, line, 0, 0});
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
