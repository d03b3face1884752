#include "hw-sim/links/local/lines_port.h"

namespace kaori::sim {

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

// An edge that does not leave is lost for a driver that reads too slowly: its level
// stays wrong until the line moves again.
void LinesPort::SendDue(Time) {
  while (const auto edge = panel_.NextEdge()) {
    Send(wire::Encode(wire::LineEdge{edge->at.time_since_epoch().count(),
                                     static_cast<std::uint32_t>(edge->line), edge->closed ? 1U : 0U}));
    if (!connected()) return;
  }
}

}  // namespace kaori::sim
