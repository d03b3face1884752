// The panel of switches and lamp on the local link: tells edges, and takes what the driver drives.
#pragma once

#include "firmware/wire/link_lines.h"
#include "hw-sim/devices/line_panel.h"
#include "hw-sim/links/local/link_port.h"

namespace kaori::sim {

// As LinkPort. A driver is told the levels when it comes, and every edge from
// then on, in order. One thread.
class LinesPort final : public LinkPort {
 public:
  // Borrows the panel.
  LinesPort(std::string path, int epoll, LinePanel& panel)
      : LinkPort(std::move(path), epoll), panel_(panel) {}

  // Edges leave with the next Pump, so that nothing falls due later.
  std::optional<Time> next_due() const override { return std::nullopt; }

 protected:
  bool Greet() override;
  void Handle(std::span<const std::uint8_t> packet) override;
  void SendDue(Time now) override;
  void PeerLeft() override { panel_.HostLeft(); }

 private:
  LinePanel& panel_;
};

}  // namespace kaori::sim
