// A microphone through ALSA, stamped by the kernel.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/audio/alsa_pcm.h"
#include "drivers/ports/microphone.h"

namespace kaori::audio {

// As ports::Microphone. After an overrun, or after the bus was suspended, the stream goes on by itself:
// that Read says resource_unavailable_try_again, and the next block is marked with `xrun`. One thread.
class AlsaMicrophone final : public ports::Microphone {
 public:
  // Opens the ALSA device `name` and starts it. Blocks for some milliseconds while the card answers.
  // `clock` measures silence and stands in for missing stamps; it must outlive the microphone. Errors:
  // those of PcmOpener, and those of starting the stream, by CauseOf.
  static Result<std::unique_ptr<AlsaMicrophone>> Open(const std::string& name,
                                                      const AlsaPreferences& preferences, const Clock& clock,
                                                      const PcmOpener& open = OpenAlsaPcm);
  int pollable() const override { return pcm_->pollable(); }
  ports::SoundFormat format() const override { return pcm_->format(); }
  // Gives 10 ms of sound at most; call it until it has none. A stream without a frame
  // for AlsaPreferences::stall counts as broken (io_error). Such a device may not
  // become readable: Read must be called now and then too.
  Result<ports::SoundBlock> Read() override;

 private:
  AlsaMicrophone(std::string name, const AlsaPreferences& preferences, const Clock& clock,
                 std::unique_ptr<AlsaPcm> pcm);
  // Goes on after an overrun or a suspended bus; `answer` is the failed call's result. Errors: as Read.
  Result<void> RecoverStream(long answer);
  // When the oldest frame that was not read was heard.
  Time TimeOfOldest();
  // Tells that no frame waits, or that none has come for too long.
  tl::unexpected<Error> NothingYet();
  // Keeps the error for every later call.
  tl::unexpected<Error> Broken(const Error& error);

  std::string name_;
  Duration stall_;
  const Clock& clock_;
  std::unique_ptr<AlsaPcm> pcm_;
  // What the caller reads, as long as the port promises: until the next Read. Allocated once.
  std::vector<std::int16_t> samples_;
  std::optional<Error> broken_;
  Time newest_;  // When the last frame came, or the stream started.
  // The next block follows a gap. Cleared when a block was given.
  bool xrun_ = false;
};

// Opens the ALSA device `name` at each call; kAnySound opens the nearest one (sound_choice.h). `clock` must
// outlive the opener and its microphones.
ports::MicrophoneOpener AlsaMicrophoneOpener(std::string name, const AlsaPreferences& preferences,
                                             const Clock& clock);

}  // namespace kaori::audio
