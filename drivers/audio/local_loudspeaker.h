// The simulator's loudspeaker: sound over packets, and notes of what was played.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/ports/loudspeaker.h"
#include "firmware/wire/link_sound.h"

namespace kaori::audio {

class LocalLoudspeaker final : public ports::Loudspeaker {
 public:
  // Connects to "<folder>/loudspeaker.<port>"; until the loudspeaker has answered, Write finds no room.
  // Borrows `clock` for its life. Errors: no_such_device (nobody is there), permission_denied.
  static Result<std::unique_ptr<ports::Loudspeaker>> Open(const std::string& folder, const Clock& clock,
                                                          const std::string& port = "loudspeaker");

  // `name` is for errors.
  LocalLoudspeaker(UniqueFd socket, std::string name, const Clock& clock)
      : socket_(std::move(socket)), name_(std::move(name)), clock_(clock) {}

  int pollable() const override { return socket_.get(); }
  ports::SoundFormat format() const override { return format_; }
  // Beside the port's: packets that make no sense end the stream as io_error.
  Result<ports::Playout> Write(std::span<const std::int16_t> samples) override;

 private:
  Result<void> ReadNotes();
  Result<void> HandlePacket(std::span<const std::uint8_t> packet);
  double Waiting(Time now) const;
  tl::unexpected<Error> Broken();

  UniqueFd socket_;
  std::string name_;
  const Clock& clock_;
  ports::SoundFormat format_;
  double room_frames_ = 0;  // 0: the hello has not come.
  std::uint64_t written_ = 0;
  wire::PlayedNote played_;  // The newest note,
  bool any_note_ = false;    // if there was one.
  std::uint32_t told_dry_ = 0;
  std::vector<std::uint8_t> packet_;
  bool broken_ = false;
};

}  // namespace kaori::audio
