// The microphone on the local link: a packet for each block.
#pragma once

#include "firmware/wire/link_sound.h"
#include "hw-sim/devices/microphone.h"
#include "hw-sim/links/local/link_port.h"

namespace kaori::sim {

// As LinkPort. What was heard while no driver listened is dropped. A driver that reads too slowly loses
// blocks, and sees it by their stamps. One thread.
class MicrophonePort final : public LinkPort {
 public:
  // Borrows the microphone and the clock, which must outlive the port.
  MicrophonePort(std::string path, int epoll, Microphone& microphone, const Clock& clock)
      : LinkPort(std::move(path), epoll), microphone_(microphone), clock_(clock) {}

  std::optional<Time> next_due() const override;

 protected:
  bool Greet() override;
  void Handle(std::span<const std::uint8_t> /*drivers say nothing*/) override {}
  void SendDue(Time now) override;

 private:
  Microphone& microphone_;
  const Clock& clock_;
};

}  // namespace kaori::sim
