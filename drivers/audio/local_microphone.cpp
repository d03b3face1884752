#include "drivers/audio/local_microphone.h"

#include "drivers/base/packet_socket.h"

namespace kaori::audio {

Result<std::unique_ptr<ports::Microphone>> LocalMicrophone::Open(const std::string& folder,
                                                                 const std::string& port) {
  const std::string path = folder + "/microphone." + port;
  auto socket = ConnectToPeer(path);
  if (socket) return std::make_unique<LocalMicrophone>(std::move(*socket), path);
  // A socket that nobody listens at is a microphone that is not plugged in.
  const bool denied = socket.error().cause == std::errc::permission_denied;
  return Fail(denied ? std::errc::permission_denied : std::errc::no_such_device, socket.error().attempt);
}

Result<ports::SoundBlock> LocalMicrophone::Read() {
  if (broken_) return Broken();
  if (!greeted_) {
    if (auto ok = ReadHello(); !ok) return tl::unexpected(ok.error());
  }
  const auto packet = Receive();
  if (!packet) return tl::unexpected(packet.error());
  const auto note = wire::DecodeSoundBlock(*packet);
  if (!note) return Broken();
  const auto bytes = packet->subspan(wire::kSoundBlockBytes);
  // Whole frames of 16-bit samples, little-endian.
  if (bytes.empty() || bytes.size() % (2 * static_cast<std::size_t>(format_.channels)) != 0) return Broken();
  samples_.resize(bytes.size() / 2);
  for (std::size_t n = 0; n < samples_.size(); ++n)
    samples_[n] = static_cast<std::int16_t>(wire::GetU16(bytes, 2 * n));
  return ports::SoundBlock{Time(Duration(note->at_ns)), note->lost != 0, samples_};
}

// Of the causes only the two that a caller handles pass as they are; a packet that is too long breaks the
// microphone.
Result<std::span<const std::uint8_t>> LocalMicrophone::Receive() {
  const auto packet = ReceivePacket(socket_.get(), packet_);
  if (packet) return std::span<const std::uint8_t>(packet_).first(packet->bytes);
  const auto cause = packet.error().cause;
  const bool expected =
      cause == std::errc::resource_unavailable_try_again || cause == std::errc::no_such_device;
  if (!expected) return Broken();
  return Fail(cause, "read " + name_);
}

Result<void> LocalMicrophone::ReadHello() {
  const auto packet = Receive();
  if (!packet) return tl::unexpected(packet.error());
  const auto hello = wire::DecodeMicrophoneHello(*packet);
  if (!hello || hello->channels < 1 || hello->channels > 2 || hello->rate_hz == 0 || hello->rate_hz > 192000)
    return Broken();
  format_ = {static_cast<int>(hello->rate_hz), static_cast<int>(hello->channels)};
  greeted_ = true;
  return {};
}

tl::unexpected<Error> LocalMicrophone::Broken() {
  broken_ = true;
  return Fail(std::errc::io_error, "understand the packets of " + name_);
}

}  // namespace kaori::audio
