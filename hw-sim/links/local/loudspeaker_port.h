// The loudspeaker on the local link: accepts sound, and tells every 5 ms what it has played.
#pragma once

#include "firmware/wire/link_sound.h"
#include "hw-sim/devices/loudspeaker.h"
#include "hw-sim/links/local/link_port.h"

namespace kaori::sim {

// As LinkPort. The driver sees from the notes how much room there is; what it
// sends beyond that is lost. One thread.
class LoudspeakerPort final : public LinkPort {
 public:
  // Borrows the loudspeaker and the clock, which must outlive the port.
  LoudspeakerPort(std::string path, int epoll, Loudspeaker& loudspeaker, const Clock& clock)
      : LinkPort(std::move(path), epoll), loudspeaker_(loudspeaker), clock_(clock) {}

  std::optional<Time> next_due() const override;

 protected:
  bool Greet() override;
  void Handle(std::span<const std::uint8_t> packet) override;
  void SendDue(Time now) override;
  void PeerLeft() override { loudspeaker_.Silence(); }

 private:
  Loudspeaker& loudspeaker_;
  const Clock& clock_;
  // When the driver was told last, and what: a note that says the same again is not sent.
  Time told_at_{};
  // Frames and underruns of the last note.
  std::uint64_t told_frames_ = 0;
  std::uint32_t told_dry_ = 0;
};

}  // namespace kaori::sim
