// A loudspeaker through ALSA.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "drivers/audio/alsa_pcm.h"
#include "drivers/ports/loudspeaker.h"

namespace kaori::audio {

// As ports::Loudspeaker. Playback starts once two periods are queued. After an underrun, or after the bus was
// suspended, it goes on by itself.
class AlsaLoudspeaker final : public ports::Loudspeaker {
 public:
  // Opens the ALSA device `name`. `clock` must outlive the loudspeaker. Errors: those of PcmOpener.
  static Result<std::unique_ptr<AlsaLoudspeaker>> Open(const std::string& name,
                                                       const AlsaPreferences& preferences, const Clock& clock,
                                                       const PcmOpener& open = OpenAlsaPcm);
  int pollable() const override { return pcm_->pollable(); }
  ports::SoundFormat format() const override { return pcm_->format(); }
  Result<ports::Playout> Write(std::span<const std::int16_t> samples) override;

 private:
  AlsaLoudspeaker(std::string name, const Clock& clock, std::unique_ptr<AlsaPcm> pcm)
      : name_(std::move(name)), clock_(clock), pcm_(std::move(pcm)) {}
  // Frames that the device accepted; `xrun` tells that it had run empty. Errors: as Write.
  Result<long> Queue(std::span<const std::int16_t> samples, bool& xrun);
  // When a frame that is written now is heard.
  Time PlayoutTime();
  // Keeps the error for every later call, unless trying again can help.
  tl::unexpected<Error> Failed(const Error& error);

  std::string name_;
  const Clock& clock_;
  std::unique_ptr<AlsaPcm> pcm_;
  std::optional<Error> broken_;
};

// Opens the ALSA device `name` at each call; kAnySound opens the nearest one (sound_choice.h). `clock` must
// outlive the opener and its loudspeakers.
ports::LoudspeakerOpener AlsaLoudspeakerOpener(std::string name, const AlsaPreferences& preferences,
                                               const Clock& clock);

}  // namespace kaori::audio
