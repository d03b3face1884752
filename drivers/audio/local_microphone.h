// The simulator's microphone: blocks of samples by packets.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/ports/microphone.h"
#include "firmware/wire/link_sound.h"

namespace kaori::audio {

// As ports::Microphone, over the local link (firmware/wire/link.h). Blocks come as the
// device made them; nothing is merged or split. One thread.
class LocalMicrophone final : public ports::Microphone {
 public:
  // Connects to the socket "<folder>/microphone.<port>". Until the microphone has answered, Read says
  // resource_unavailable_try_again. Errors: no_such_device (nobody listens), permission_denied.
  static Result<std::unique_ptr<ports::Microphone>> Open(const std::string& folder,
                                                         const std::string& port = "microphone");

  // `name` is for errors.
  LocalMicrophone(UniqueFd socket, std::string name) : socket_(std::move(socket)), name_(std::move(name)) {}

  int pollable() const override { return socket_.get(); }
  ports::SoundFormat format() const override { return format_; }
  // Packets that make no sense break the stream.
  Result<ports::SoundBlock> Read() override;

 private:
  // The next packet, within packet_ until the next call. Errors: as Read.
  Result<std::span<const std::uint8_t>> Receive();
  // Reads the format, which the first packet has. Errors: as Read.
  Result<void> ReadHello();
  // Every later Read fails like this one: a peer that sends nonsense once is not trusted again.
  tl::unexpected<Error> Broken();

  UniqueFd socket_;
  // For errors: the socket's path.
  std::string name_;
  // As the hello told it; the default of the type until then.
  ports::SoundFormat format_;
  // Room for the longest packet of the link.
  std::array<std::uint8_t, wire::kMaxLinkPacket> packet_;
  std::vector<std::int16_t> samples_;  // What the caller reads.
  // The hello was read, and format_ holds.
  bool greeted_ = false;
  // A packet made no sense, or the device is gone.
  bool broken_ = false;
};

}  // namespace kaori::audio
