#include "hw-sim/links/local/loudspeaker_port.h"

#include <vector>

namespace kaori::sim {
namespace {

// As often as real devices interrupt; the driver reckons in between by the rate.
constexpr Duration kTellPeriod = std::chrono::milliseconds(5);

}  // namespace

std::optional<Time> LoudspeakerPort::next_due() const {
  if (!connected() || loudspeaker_.stalled()) return std::nullopt;
  return told_at_ + kTellPeriod;
}

// The driver reckons from the room how much it may send ahead of the first note.
bool LoudspeakerPort::Greet() {
  const ports::SoundFormat format = loudspeaker_.format();
  told_at_ = clock_.now();
  told_frames_ = 0;
  return Send(wire::Encode(wire::LoudspeakerHello{static_cast<std::uint32_t>(format.rate_hz),
                                                  static_cast<std::uint32_t>(format.channels),
                                                  static_cast<std::uint32_t>(Loudspeaker::kRoomFrames)}));
}

void LoudspeakerPort::Handle(std::span<const std::uint8_t> packet) {
  // Half a frame cannot be played: left and right would change places from then on.
  if (packet.size() % (2 * std::size_t{Loudspeaker::kChannels}) != 0) return HangUp();
  std::vector<std::int16_t> samples(packet.size() / 2);
  for (std::size_t n = 0; n < samples.size(); ++n)
    // Signed 16 bits, little endian, a frame's channels in turn.
    samples[n] = static_cast<std::int16_t>(wire::GetU16(packet, 2 * n));
  loudspeaker_.Play(samples, clock_.now());
}

// Plays what is due before telling of it: the note is of now.
void LoudspeakerPort::SendDue(Time now) {
  loudspeaker_.PlayUntil(now);
  if (now - told_at_ < kTellPeriod) return;
  told_at_ = now;
  if (loudspeaker_.played_frames() == told_frames_ && loudspeaker_.dry() == told_dry_) return;
  told_dry_ = loudspeaker_.dry();
  told_frames_ = loudspeaker_.played_frames();
  Send(wire::Encode(wire::PlayedNote{loudspeaker_.played_at().time_since_epoch().count(), told_frames_,
                                     loudspeaker_.dry()}));
}

}  // namespace kaori::sim
