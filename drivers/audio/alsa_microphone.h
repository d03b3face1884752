// A microphone through ALSA: never waiting, every frame with the kernel's time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/audio/alsa_pcm.h"
#include "drivers/ports/microphone.h"

namespace kaori::audio {

// As ports::Microphone. A stream that overran or slept goes on by itself; the next block says xrun.
class AlsaMicrophone final : public ports::Microphone {
 public:
  // Opens `name` and starts it. Borrows `clock` for its life. Errors: those of PcmOpener.
  static Result<std::unique_ptr<AlsaMicrophone>> Open(const std::string& name, const AlsaWish& wish,
                                                      const Clock& clock,
                                                      const PcmOpener& open = OpenAlsaPcm);
  int pollable() const override { return pcm_->pollable(); }
  ports::SoundFormat format() const override { return pcm_->format(); }
  // Beside the port's: a stream without a frame for AlsaWish::stall is an io_error; ask now and then.
  Result<ports::SoundBlock> Read() override;

 private:
  AlsaMicrophone(std::string name, const AlsaWish& wish, const Clock& clock, std::unique_ptr<AlsaPcm> pcm);
  Result<void> GoOn(long answer);
  Time StampOfOldest();
  tl::unexpected<Error> NothingYet();
  tl::unexpected<Error> Broken(const Error& error);

  std::string name_;
  Duration stall_;
  const Clock& clock_;
  std::unique_ptr<AlsaPcm> pcm_;
  std::vector<std::int16_t> samples_;  // What the caller looks at.
  std::optional<Error> broken_;
  Time newest_;  // When the last frame came, or the stream started.
  bool xrun_ = false;
};

// Opens the microphone `name` anew each time; kAnySound is the nearest one (sound_choice.h). Borrows `clock`
// for its life.
ports::MicrophoneOpener AlsaMicrophoneOpener(std::string name, const AlsaWish& wish, const Clock& clock);

}  // namespace kaori::audio
