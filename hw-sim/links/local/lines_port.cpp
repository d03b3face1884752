#include "hw-sim/links/local/lines_port.h"

#include "hw-sim/devices/report_queue.h"

namespace kaori::sim {

std::optional<Time> LinesPort::next_due() const {
  if (!unsent_) return std::nullopt;
  // The socket was full: it is tried again after as long as a report of other devices takes.
  return clock_.now() + kReportPeriod;
}

bool LinesPort::Greet() {
  // Older edges are dropped before the levels are read: the hello says how things stand.
  panel_.HostCame();
  return Send(wire::Encode(wire::LinesHello{LinePanel::kInputs, LinePanel::kOutputs, panel_.closed()}));
}

void LinesPort::Handle(std::span<const std::uint8_t> packet) {
  const auto drive = wire::DecodeLineDrive(packet);
  // The driver must know how many lines there are: it was told.
  if (!drive || drive->line >= LinePanel::kOutputs) return HangUp();
  panel_.Drive(static_cast<int>(drive->line), drive->active != 0);
}

// An edge that did not fit stays first in the queue: edges never overtake each other.
void LinesPort::SendDue(Time) {
  if (!unsent_) unsent_ = panel_.NextEdge();
  while (unsent_) {
    const bool left = Send(
        wire::Encode(wire::LineEdge{unsent_->at.time_since_epoch().count(),
                                    static_cast<std::uint32_t>(unsent_->line), unsent_->closed ? 1U : 0U}));
    // Either the driver reads too slowly, or it has gone, and PeerLeft has forgotten the edge.
    if (!left) return;
    unsent_ = panel_.NextEdge();
  }
}

void LinesPort::PeerLeft() {
  unsent_.reset();
  panel_.HostLeft();
}

}  // namespace kaori::sim
