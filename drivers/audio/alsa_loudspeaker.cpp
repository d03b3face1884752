#include "drivers/audio/alsa_loudspeaker.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include "drivers/audio/sound_choice.h"

namespace kaori::audio {

Result<std::unique_ptr<AlsaLoudspeaker>> AlsaLoudspeaker::Open(const std::string& name, const AlsaWish& wish,
                                                               const Clock& clock, const PcmOpener& open) {
  auto pcm = open(name, Direction::kPlayback, wish);
  if (!pcm) return tl::unexpected(pcm.error());
  return std::unique_ptr<AlsaLoudspeaker>(new AlsaLoudspeaker(name, clock, std::move(*pcm)));
}

Result<ports::Playout> AlsaLoudspeaker::Write(std::span<const std::int16_t> samples) {
  if (broken_) return tl::unexpected(*broken_);
  const auto channels = static_cast<std::size_t>(pcm_->format().channels);
  if (samples.empty() || samples.size() % channels != 0)
    return FailInput("play whole frames on " + name_);
  Time at = HeardNext();
  bool xrun = false;
  const auto frames = Queue(samples, xrun);
  if (!frames) return tl::unexpected(frames.error());
  if (xrun) at = HeardNext() - Span(pcm_->format(), *frames);  // Nothing else waits there now.
  return ports::Playout{static_cast<std::size_t>(*frames), at, xrun};
}

// One that ran dry takes the frames at the second try.
Result<long> AlsaLoudspeaker::Queue(std::span<const std::int16_t> samples, bool& xrun) {
  long frames = pcm_->Write(samples);
  if (frames == -EPIPE || frames == -ESTRPIPE) {
    xrun = true;
    if (auto ok = Recover(*pcm_, frames, name_); !ok) return Refused(ok.error());
    frames = pcm_->Write(samples);
  }
  if (frames == 0 || frames == -EAGAIN)
    return Fail(std::errc::resource_unavailable_try_again, "find room in " + name_);
  if (frames > 0) return frames;
  const bool gone = CauseOf(frames) == std::errc::no_such_device;
  return Refused({gone ? std::errc::no_such_device : std::errc::io_error, "play on " + name_});
}

Time AlsaLoudspeaker::HeardNext() {
  PcmStatus status;
  if (pcm_->Status(status) < 0) return clock_.now();  // Write tells what is wrong.
  return status.at.value_or(clock_.now()) + Span(pcm_->format(), std::max(status.delay_frames, 0L));
}

tl::unexpected<Error> AlsaLoudspeaker::Refused(const Error& error) {
  if (error.cause != std::errc::resource_unavailable_try_again) broken_ = error;
  return tl::unexpected(error);
}

ports::LoudspeakerOpener AlsaLoudspeakerOpener(std::string name, const AlsaWish& wish, const Clock& clock) {
  return [name = std::move(name), wish, &clock,
          open = ChoosingPcmOpener(clock)]() -> Result<std::unique_ptr<ports::Loudspeaker>> {
    return AlsaLoudspeaker::Open(name, wish, clock, open);
  };
}

}  // namespace kaori::audio
