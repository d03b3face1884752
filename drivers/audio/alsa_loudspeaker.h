// A loudspeaker through ALSA: never waiting, and telling when each part will be heard.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "drivers/audio/alsa_pcm.h"
#include "drivers/ports/loudspeaker.h"

namespace kaori::audio {

// As ports::Loudspeaker. It begins to sound once two periods wait; one that ran dry or slept goes on by
// itself.
class AlsaLoudspeaker final : public ports::Loudspeaker {
 public:
  // Borrows `clock` for its life. Errors: those of PcmOpener.
  static Result<std::unique_ptr<AlsaLoudspeaker>> Open(const std::string& name, const AlsaWish& wish,
                                                       const Clock& clock,
                                                       const PcmOpener& open = OpenAlsaPcm);
  int pollable() const override { return pcm_->pollable(); }
  ports::SoundFormat format() const override { return pcm_->format(); }
  Result<ports::Playout> Write(std::span<const std::int16_t> samples) override;

 private:
  AlsaLoudspeaker(std::string name, const Clock& clock, std::unique_ptr<AlsaPcm> pcm)
      : name_(std::move(name)), clock_(clock), pcm_(std::move(pcm)) {}
  Result<long> Queue(std::span<const std::int16_t> samples, bool& xrun);
  Time HeardNext();
  tl::unexpected<Error> Refused(const Error& error);

  std::string name_;
  const Clock& clock_;
  std::unique_ptr<AlsaPcm> pcm_;
  std::optional<Error> broken_;
};

// Opens the loudspeaker `name` anew each time; kAnySound is the nearest one (sound_choice.h). Borrows `clock`
// for its life.
ports::LoudspeakerOpener AlsaLoudspeakerOpener(std::string name, const AlsaWish& wish, const Clock& clock);

}  // namespace kaori::audio
