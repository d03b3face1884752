#include "hw-sim/links/local/microphone_port.h"

#include <algorithm>
#include <vector>

namespace kaori::sim {

std::optional<Time> MicrophonePort::next_due() const {
  if (!connected() || microphone_.stalled()) return std::nullopt;
  return microphone_.next_due();
}

bool MicrophonePort::Greet() {
  // A driver hears what is said from now on.
  microphone_.Drop(clock_.now());
  const ports::SoundFormat format = microphone_.format();
  return Send(wire::Encode(wire::MicrophoneHello{static_cast<std::uint32_t>(format.rate_hz),
                                                 static_cast<std::uint32_t>(format.channels)}));
}

void MicrophonePort::SendDue(Time now) {
  while (const auto block = microphone_.NextBlock(now)) {
    // Note and samples are one packet, so that no block is ever taken for another's.
    const auto head =
        wire::Encode(wire::SoundBlockNote{block->at.time_since_epoch().count(), block->lost ? 1U : 0U});
    std::vector<std::uint8_t> packet(head.size() + 2 * block->samples.size());
    std::ranges::copy(head, packet.begin());
    for (std::size_t n = 0; n < block->samples.size(); ++n)
      wire::PutU16(packet, head.size() + 2 * n, static_cast<std::uint16_t>(block->samples[n]));
    Send(packet);  // A driver that reads too slowly loses it: the stamps tell.
    if (!connected()) return;
  }
}

}  // namespace kaori::sim
