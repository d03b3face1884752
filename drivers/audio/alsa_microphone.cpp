#include "drivers/audio/alsa_microphone.h"

#include <cerrno>
#include <utility>

#include "drivers/audio/sound_choice.h"

namespace kaori::audio {
namespace {

// Of one block: 10 ms, so that the voice is followed as finely as the picture is drawn.
constexpr std::size_t kMostFrames = 480;

}  // namespace

Result<std::unique_ptr<AlsaMicrophone>> AlsaMicrophone::Open(const std::string& name,
                                                             const AlsaPreferences& preferences,
                                                             const Clock& clock, const PcmOpener& open) {
  auto pcm = open(name, Direction::kCapture, preferences);
  if (!pcm) return tl::unexpected(pcm.error());
  if (const int started = (*pcm)->Start(); started < 0)
    return Fail(CauseOf(started), "start sound device " + name);
  return std::unique_ptr<AlsaMicrophone>(new AlsaMicrophone(name, preferences, clock, std::move(*pcm)));
}

AlsaMicrophone::AlsaMicrophone(std::string name, const AlsaPreferences& preferences, const Clock& clock,
                               std::unique_ptr<AlsaPcm> pcm)
    : name_(std::move(name)),
      stall_(preferences.stall),
      clock_(clock),
      pcm_(std::move(pcm)),
      newest_(clock.now()) {
  samples_.resize(kMostFrames * static_cast<std::size_t>(pcm_->format().channels));
}

// The block borrows `samples_` until the next Read. An error that a stream recovers from is no failure here:
// it shows as the mark of a gap on the next block.
Result<ports::SoundBlock> AlsaMicrophone::Read() {
  if (broken_) return tl::unexpected(*broken_);
  // Taken before reading: afterwards other frames are the oldest.
  const Time at = TimeOfOldest();
  const long frames = pcm_->Read(samples_);
  if (frames == 0 || frames == -EAGAIN) return NothingYet();
  if (frames < 0) {
    if (auto ok = RecoverStream(frames); !ok) return tl::unexpected(ok.error());
    return NothingYet();
  }
  newest_ = clock_.now();
  const auto count = static_cast<std::size_t>(frames * pcm_->format().channels);
  return ports::SoundBlock{at, std::exchange(xrun_, false), std::span(samples_).first(count)};
}

// The kernel's stamp is when it last counted the frames that wait; the oldest of them is older by their
// length. It must be asked before the frames are read, since reading changes the count.
Time AlsaMicrophone::TimeOfOldest() {
  PcmStatus status;
  if (pcm_->Status(status) < 0) return clock_.now();  // Read reports the fault.
  return status.at.value_or(clock_.now()) - Span(pcm_->format(), status.delay_frames);
}

// A capture that is only prepared never becomes readable: it is started here, where playback starts with its
// first frames.
Result<void> AlsaMicrophone::RecoverStream(long answer) {
  // The next block follows a gap.
  xrun_ = true;
  auto recovered = Recover(*pcm_, answer, name_);
  if (!recovered) {
    // The bus resumes by itself: the next Read tries again.
    if (recovered.error().cause == std::errc::resource_unavailable_try_again) return recovered;
    return Broken(recovered.error());
  }
  const int started = pcm_->Start();
  if (started < 0 && started != -EBADFD)  // EBADFD: it resumed, and runs already.
    return Broken({CauseOf(started), "start sound device " + name_});
  return {};
}

tl::unexpected<Error> AlsaMicrophone::NothingYet() {
  // Some devices stop without an error: silence in frames tells.
  if (clock_.now() - newest_ > stall_) return Broken({std::errc::io_error, "wait any longer for " + name_});
  return Fail(std::errc::resource_unavailable_try_again, "read " + name_);
}

tl::unexpected<Error> AlsaMicrophone::Broken(const Error& error) {
  broken_ = error;
  return tl::unexpected(error);
}

ports::MicrophoneOpener AlsaMicrophoneOpener(std::string name, const AlsaPreferences& preferences,
                                             const Clock& clock) {
  return [name = std::move(name), preferences, &clock,
          open = ChoosingPcmOpener(clock)]() -> Result<std::unique_ptr<ports::Microphone>> {
    return AlsaMicrophone::Open(name, preferences, clock, open);
  };
}

}  // namespace kaori::audio
