// What the simulated loudspeaker has played, as packets for the page's own loudspeaker.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hw-sim/devices/loudspeaker.h"

namespace kaori::console {

// Pure: bytes of sound in, packets out. One thread. Real time is the page's
// business: packets have no stamps.
//
// A packet is u32 number of frames, u32 rate in Hz, then the frames, each of two samples of 16 bit (left,
// right); all of it little-endian. page/sound.js reads it. What was silent because nothing was played is left
// out: the page plays what comes, a little later than it was heard here.
class SoundPackets {
 public:
  // At most so much is kept while nobody fetches it: older sound is dropped.
  static constexpr std::size_t kMostFrames = 24'000;  // Half a second.
  // A packet is worth sending from here on.
  static constexpr std::size_t kWorthFrames = 960;  // 20 ms.

  // Adds what was heard since the last call; of more than half a second the oldest part is dropped.
  void Add(const std::vector<sim::Loudspeaker::Heard>& heard);

  // Whether Next has enough to be worth a packet.
  bool ready() const { return samples_.size() / sim::Loudspeaker::kChannels >= kWorthFrames; }

  // Everything that was added, as one packet; afterwards nothing is kept. A
  // packet without a frame is possible.
  std::string Next();

  // Forgets what was added: nobody listens.
  void Clear() { samples_.clear(); }

 private:
  std::vector<std::int16_t> samples_;  // Left, right.
};

}  // namespace kaori::console
