#include "hw-sim/console/sound_packets.h"

#include "firmware/wire/bytes.h"

namespace kaori::console {
namespace {

// Number of frames and rate, as sound.js reads them.
constexpr std::size_t kHeadBytes = 8;
// The drift of a simulated crystal, some ppm, is not heard: packets tell the nominal rate.
constexpr std::uint32_t kRate_hz = 48'000;

}  // namespace

void SoundPackets::Add(const std::vector<sim::Loudspeaker::Heard>& heard) {
  for (const auto& block : heard) samples_.insert(samples_.end(), block.samples.begin(), block.samples.end());
  constexpr std::size_t kMostSamples = kMostFrames * sim::Loudspeaker::kChannels;
  if (samples_.size() > kMostSamples)
    samples_.erase(samples_.begin(), samples_.end() - static_cast<std::ptrdiff_t>(kMostSamples));
}

std::string SoundPackets::Next() {
  std::vector<std::uint8_t> bytes(kHeadBytes + 2 * samples_.size());
  wire::PutU32(bytes, 0, static_cast<std::uint32_t>(samples_.size() / sim::Loudspeaker::kChannels));
  wire::PutU32(bytes, 4, kRate_hz);
  for (std::size_t n = 0; n < samples_.size(); ++n) wire::PutI16(bytes, kHeadBytes + 2 * n, samples_[n]);
  samples_.clear();
  return {bytes.begin(), bytes.end()};
}

}  // namespace kaori::console
