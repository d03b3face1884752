#include "drivers/audio/alsa_loudspeaker.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include "drivers/audio/sound_choice.h"

namespace kaori::audio {

Result<std::unique_ptr<AlsaLoudspeaker>> AlsaLoudspeaker::Open(const std::string& name,
                                                               const AlsaPreferences& preferences,
                                                               const Clock& clock, const PcmOpener& open) {
  auto pcm = open(name, Direction::kPlayback, preferences);
  if (!pcm) return tl::unexpected(pcm.error());
  return std::unique_ptr<AlsaLoudspeaker>(new AlsaLoudspeaker(name, clock, std::move(*pcm)));
}

// After an xrun nothing else is queued: the frames begin at once, so that their time follows from the delay
// behind them less their own length.
Result<ports::Playout> AlsaLoudspeaker::Write(std::span<const std::int16_t> samples) {
  if (broken_) return tl::unexpected(*broken_);
  const auto channels = static_cast<std::size_t>(pcm_->format().channels);
  if (samples.empty() || samples.size() % channels != 0) return FailInput("play whole frames on " + name_);
  // Taken before writing: the delay counts what is queued before these frames.
  Time at = PlayoutTime();
  bool xrun = false;
  const auto frames = Queue(samples, xrun);
  if (!frames) return tl::unexpected(frames.error());
  if (xrun) at = PlayoutTime() - Span(pcm_->format(), *frames);  // Nothing else is queued now.
  return ports::Playout{static_cast<std::size_t>(*frames), at, xrun};
}

// After an underrun the second try queues the frames.
Result<long> AlsaLoudspeaker::Queue(std::span<const std::int16_t> samples, bool& xrun) {
  long frames = pcm_->Write(samples);
  if (frames == -EPIPE || frames == -ESTRPIPE) {
    xrun = true;
    if (auto ok = Recover(*pcm_, frames, name_); !ok) return Failed(ok.error());
    frames = pcm_->Write(samples);
  }
  if (frames == 0 || frames == -EAGAIN)
    return Fail(std::errc::resource_unavailable_try_again, "queue frames on " + name_);
  if (frames > 0) return frames;
  // Whatever else fails counts as a broken stream: opening it anew mends most of it.
  const bool gone = CauseOf(frames) == std::errc::no_such_device;
  return Failed({gone ? std::errc::no_such_device : std::errc::io_error, "play on " + name_});
}

Time AlsaLoudspeaker::PlayoutTime() {
  PcmStatus status;
  if (pcm_->Status(status) < 0) return clock_.now();  // Write reports the fault.
  // The delay may be negative after an underrun.
  return status.at.value_or(clock_.now()) + Span(pcm_->format(), std::max(status.delay_frames, 0L));
}

tl::unexpected<Error> AlsaLoudspeaker::Failed(const Error& error) {
  // Only a bus that has not resumed yet may be tried again.
  if (error.cause != std::errc::resource_unavailable_try_again) broken_ = error;
  return tl::unexpected(error);
}

ports::LoudspeakerOpener AlsaLoudspeakerOpener(std::string name, const AlsaPreferences& preferences,
                                               const Clock& clock) {
  return [name = std::move(name), preferences, &clock,
          open = ChoosingPcmOpener(clock)]() -> Result<std::unique_ptr<ports::Loudspeaker>> {
    return AlsaLoudspeaker::Open(name, preferences, clock, open);
  };
}

}  // namespace kaori::audio
