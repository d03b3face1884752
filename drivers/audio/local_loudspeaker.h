// The simulator's loudspeaker: samples by packets, and packets back that tell what was played.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/ports/loudspeaker.h"
#include "firmware/wire/link_sound.h"

namespace kaori::audio {

// As ports::Loudspeaker, over the local link (firmware/wire/link.h). There is no queue here: frames are
// sent at once, and the simulated device queues them. One thread.
class LocalLoudspeaker final : public ports::Loudspeaker {
 public:
  // Connects to the socket "<folder>/loudspeaker.<port>". Until the loudspeaker
  // has answered, Write says resource_unavailable_try_again. `clock` must
  // outlive it. Errors: no_such_device (nobody listens), permission_denied.
  static Result<std::unique_ptr<ports::Loudspeaker>> Open(const std::string& folder, const Clock& clock,
                                                          const std::string& port = "loudspeaker");

  // `name` is for errors.
  LocalLoudspeaker(UniqueFd socket, std::string name, const Clock& clock)
      : socket_(std::move(socket)), name_(std::move(name)), clock_(clock) {}

  int pollable() const override { return socket_.get(); }
  ports::SoundFormat format() const override { return format_; }
  // Packets that make no sense break the stream.
  Result<ports::Playout> Write(std::span<const std::int16_t> samples) override;

 private:
  // Reads what the loudspeaker has told since the last call. Errors: as Write.
  Result<void> ReadNotes();
  // Applies one packet: the hello first, notes of what was played afterwards.
  Result<void> HandlePacket(std::span<const std::uint8_t> packet);
  // Between two notes the queue is reckoned by the rate, so that stamps do not jump. Zero where it must have
  // run empty by then.
  double QueuedFrames(Time now) const;
  tl::unexpected<Error> Broken();

  UniqueFd socket_;
  std::string name_;
  const Clock& clock_;
  // As the hello says; the default until it has come.
  ports::SoundFormat format_;
  // How many frames the device queues at most, as its hello says. Kept as
  // a double, since the reckoned queue is one.
  double room_frames_ = 0;  // 0 before the hello.
  // Frames since the loudspeaker was opened, which its notes count as well.
  std::uint64_t written_ = 0;
  std::optional<wire::PlayedNote> played_;  // The newest note.
  // The count of underruns that was told by Playout::xrun already.
  std::uint32_t reported_underruns_ = 0;
  std::vector<std::uint8_t> packet_;
  // A packet made no sense. Every later call says so.
  bool broken_ = false;
};

}  // namespace kaori::audio
