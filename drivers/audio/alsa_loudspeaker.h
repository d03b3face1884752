// A loudspeaker through ALSA.
//
// What is heard when follows from the kernel's delay (snd_pcm_delay(3)): the frames that are written and not
// yet played, those in the device's own queue included.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "drivers/audio/alsa_pcm.h"
#include "drivers/ports/loudspeaker.h"

namespace kaori::audio {

// As ports::Loudspeaker. Playback starts once two periods are queued, so that the first interrupt does
// not find the queue empty. After an underrun, or after the bus was suspended, it goes on by itself: the
// write that notices it prepares the device and queues its frames as the first ones. One thread.
class AlsaLoudspeaker final : public ports::Loudspeaker {
 public:
  // Opens the ALSA device `name` and sets it; nothing is heard before the first Write. Blocks for some
  // milliseconds while the card answers. `clock` stands in for the stamps of devices that have none,
  // and must outlive the loudspeaker. Errors: those of PcmOpener.
  static Result<std::unique_ptr<AlsaLoudspeaker>> Open(const std::string& name,
                                                       const AlsaPreferences& preferences, const Clock& clock,
                                                       const PcmOpener& open = OpenAlsaPcm);
  int pollable() const override { return pcm_->pollable(); }
  ports::SoundFormat format() const override { return pcm_->format(); }
  // Allocates nothing.
  Result<ports::Playout> Write(std::span<const std::int16_t> samples) override;

 private:
  AlsaLoudspeaker(std::string name, const Clock& clock, std::unique_ptr<AlsaPcm> pcm)
      : name_(std::move(name)), clock_(clock), pcm_(std::move(pcm)) {}
  // Frames that the device accepted, above 0; `xrun` tells that it had run empty. Errors: as Write.
  Result<long> Queue(std::span<const std::int16_t> samples, bool& xrun);
  // When a frame that is written now is heard: the kernel's count of what is queued
  // before it, from the moment of that count on. The present, where the device does not
  // answer: Write meets the same fault and reports it.
  Time PlayoutTime();
  // Keeps the error for every later call, unless trying again can help:
  // only a bus that has not resumed yet does.
  tl::unexpected<Error> Failed(const Error& error);

  std::string name_;
  const Clock& clock_;
  std::unique_ptr<AlsaPcm> pcm_;
  // Set once; from then on Write says the same without asking ALSA,
  // which may block for a device that was pulled.
  std::optional<Error> broken_;
};

// Opens the ALSA device `name` at each call; kAnySound opens the nearest one
// (sound_choice.h). One opener may be called again and again: it keeps nothing of the earlier
// devices. `clock` must outlive the opener and its loudspeakers.
ports::LoudspeakerOpener AlsaLoudspeakerOpener(std::string name, const AlsaPreferences& preferences,
                                               const Clock& clock);

}  // namespace kaori::audio
