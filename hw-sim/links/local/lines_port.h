// The panel of switches and lamp on the local link: tells edges, and takes what the driver drives.
#pragma once

#include "firmware/wire/link_lines.h"
#include "hw-sim/devices/line_panel.h"
#include "hw-sim/links/local/link_port.h"

namespace kaori::sim {

// As LinkPort. A driver is told the levels when it comes, and every edge from then on, in order. One that
// reads too slowly is told later; what is lost for one that does not read at all is said at
// LinePanel::NextEdge. One thread.
class LinesPort final : public LinkPort {
 public:
  // Borrows the panel and the clock, which must outlive the port.
  LinesPort(std::string path, int epoll, LinePanel& panel, const Clock& clock)
      : LinkPort(std::move(path), epoll), panel_(panel), clock_(clock) {}

  std::optional<Time> next_due() const override;

 protected:
  bool Greet() override;
  void Handle(std::span<const std::uint8_t> packet) override;
  void SendDue(Time now) override;
  void PeerLeft() override;

 private:
  LinePanel& panel_;
  const Clock& clock_;
  // Left the panel, but the driver reads too slowly. It is sent before any later edge.
  std::optional<LinePanel::Edge> unsent_;
};

}  // namespace kaori::sim
