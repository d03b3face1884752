#include "drivers/audio/local_loudspeaker.h"

#include <algorithm>
#include <array>
#include <utility>

#include "drivers/base/packet_socket.h"

namespace kaori::audio {
namespace {

constexpr int kNotesAtOnce = 64;  // In one call: a loudspeaker that never stops must not hold us.
// Frames in one packet: 4096 bytes of mono, 8192 of stereo, which is kMaxLinkPacket.
constexpr std::size_t kMostAtOnce = 2048;
// A bound for a hello that makes no sense: 22 s at 48 kHz.
constexpr std::uint32_t kMostRoom_frames = 1U << 20U;

}  // namespace

Result<std::unique_ptr<ports::Loudspeaker>> LocalLoudspeaker::Open(const std::string& folder,
                                                                   const Clock& clock,
                                                                   const std::string& port) {
  const std::string path = folder + "/loudspeaker." + port;
  auto socket = ConnectToPeer(path);
  if (socket) return std::make_unique<LocalLoudspeaker>(std::move(*socket), path, clock);
  // A socket that nobody listens at is a loudspeaker that is not plugged in.
  const bool denied = socket.error().cause == std::errc::permission_denied;
  return Fail(denied ? std::errc::permission_denied : std::errc::no_such_device, socket.error().attempt);
}

Result<ports::Playout> LocalLoudspeaker::Write(std::span<const std::int16_t> samples) {
  if (broken_) return Broken();
  if (auto ok = ReadNotes(); !ok) return tl::unexpected(ok.error());
  const auto channels = static_cast<std::size_t>(format_.channels);
  if (samples.empty() || samples.size() % channels != 0) return FailInput("play whole frames on " + name_);
  const Time now = clock_.now();
  const double queued = QueuedFrames(now);
  // Rounded down: a frame of which only a part would fit waits.
  const auto room_left = static_cast<std::size_t>(std::max(0.0, room_frames_ - queued));
  const std::size_t frames = std::min({samples.size() / channels, room_left, kMostAtOnce});
  const auto full = Fail(std::errc::resource_unavailable_try_again, "queue frames on " + name_);
  if (frames == 0) return full;
  packet_.resize(frames * channels * 2);
  for (std::size_t n = 0; n < frames * channels; ++n)
    wire::PutU16(packet_, 2 * n, static_cast<std::uint16_t>(samples[n]));
  const auto sent = SendPacket(socket_.get(), packet_);
  // A simulator that reads too slowly looks like a device whose buffer is full.
  if (!sent && sent.error().cause == std::errc::resource_unavailable_try_again) return full;
  if (!sent) return Fail(std::errc::no_such_device, "play on " + name_);
  written_ += frames;
  const std::uint32_t underruns = played_ ? played_->dry : 0;
  const bool xrun = std::exchange(reported_underruns_, underruns) != underruns;
  return ports::Playout{frames, now + FromSeconds(queued / format_.rate_hz), xrun};
}

// How many frames are not played by `now`: those of the newest note, less what the rate has played since.
double LocalLoudspeaker::QueuedFrames(Time now) const {
  if (!played_) return static_cast<double>(written_);
  const double since_s = Seconds(now - Time(Duration(played_->at_ns)));
  const double then = static_cast<double>(written_) - static_cast<double>(played_->frames);
  return std::clamp(then - since_s * format_.rate_hz, 0.0, static_cast<double>(kMostRoom_frames));
}

Result<void> LocalLoudspeaker::ReadNotes() {
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  for (int n = 0; n < kNotesAtOnce; ++n) {
    const auto packet = ReceivePacket(socket_.get(), buffer);
    if (packet) {
      if (auto ok = HandlePacket(std::span(buffer).first(packet->bytes)); !ok) return ok;
    } else if (packet.error().cause == std::errc::resource_unavailable_try_again) {
      return {};
    } else if (packet.error().cause == std::errc::no_such_device) {
      return Fail(std::errc::no_such_device, "play on " + name_);
    } else {
      return Broken();
    }
  }
  return {};
}

// A hello or a note that makes no sense breaks the loudspeaker for good: its counts would be wrong from then
// on.
Result<void> LocalLoudspeaker::HandlePacket(std::span<const std::uint8_t> packet) {
  // The first packet is the hello.
  if (room_frames_ == 0) {
    const auto hello = wire::DecodeLoudspeakerHello(packet);
    if (!hello || hello->channels < 1 || hello->channels > 2 || hello->rate_hz < 8000 ||
        hello->rate_hz > 192000 || hello->room_frames == 0 || hello->room_frames > kMostRoom_frames)
      return Broken();
    format_ = {static_cast<int>(hello->rate_hz), static_cast<int>(hello->channels)};
    room_frames_ = hello->room_frames;
    return {};
  }
  const auto note = wire::DecodePlayed(packet);
  // No loudspeaker has played more than it was given.
  if (!note || note->frames > written_) return Broken();
  played_ = *note;
  return {};
}

tl::unexpected<Error> LocalLoudspeaker::Broken() {
  broken_ = true;
  return Fail(std::errc::io_error, "understand the packets of " + name_);
}

}  // namespace kaori::audio
