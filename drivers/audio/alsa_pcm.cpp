#include "drivers/audio/alsa_pcm.h"

#include <alsa/asoundlib.h>
#include <sys/epoll.h>

#include <algorithm>
#include <array>
#include <utility>

namespace kaori::audio {
namespace {

// Every USB microphone and every HDMI output has this rate. One rate for all
// spares a conversion, and its error, in every reader.
constexpr unsigned kRate_hz = 48000;
// A plug-in of ALSA may have several; a device of the kernel has one.
constexpr std::size_t kMostDescriptors = 8;

// Owns a PCM from the line on that opened it.
struct CloseHandle {
  void operator()(snd_pcm_t* handle) const { snd_pcm_close(handle); }
};
using Handle = std::unique_ptr<snd_pcm_t, CloseHandle>;

unsigned Microseconds(Duration d) {
  return static_cast<unsigned>(std::chrono::duration_cast<std::chrono::microseconds>(d).count());
}

// The preferred number of channels, or else the other one.
Result<int> ChooseChannels(snd_pcm_t* pcm, snd_pcm_hw_params_t* params, int preferred) {
  for (const int channels : {preferred, 3 - preferred})
    if (snd_pcm_hw_params_set_channels(pcm, params, static_cast<unsigned>(channels)) == 0) return channels;
  return Fail(std::errc::not_supported, "find a mode with one channel or two");
}

Result<ports::SoundFormat> SetHardware(snd_pcm_t* pcm, const AlsaPreferences& preferences) {
  snd_pcm_hw_params_t* params = nullptr;
  snd_pcm_hw_params_alloca(&params);
  if (const int any = snd_pcm_hw_params_any(pcm, params); any < 0)
    return Fail(CauseOf(any), "read its modes");
  // The kernel's PCM knows no conversion: a mode that is refused here the hardware does not have.
  if (snd_pcm_hw_params_set_access(pcm, params, SND_PCM_ACCESS_RW_INTERLEAVED) < 0 ||
      snd_pcm_hw_params_set_format(pcm, params, SND_PCM_FORMAT_S16) < 0 ||
      snd_pcm_hw_params_set_rate(pcm, params, kRate_hz, 0) < 0)
    return Fail(std::errc::not_supported, "find a mode of 16 bits at 48 kHz");
  const auto channels = ChooseChannels(pcm, params, preferences.channels == 2 ? 2 : 1);
  if (!channels) return tl::unexpected(channels.error());
  unsigned period_us = Microseconds(preferences.period), buffer_us = Microseconds(preferences.buffer);
  // Both sizes are wishes: the device goes as near as it can, and the delay is asked for anyway.
  snd_pcm_hw_params_set_period_time_near(pcm, params, &period_us, nullptr);
  snd_pcm_hw_params_set_buffer_time_near(pcm, params, &buffer_us, nullptr);
  if (const int set = snd_pcm_hw_params(pcm, params); set < 0) return Fail(CauseOf(set), "set its mode");
  return ports::SoundFormat{static_cast<int>(kRate_hz), *channels};
}

// Stamps by CLOCK_MONOTONIC; playback starts once two periods are queued.
Result<void> SetSoftware(snd_pcm_t* pcm) {
  snd_pcm_uframes_t buffer = 0, period = 0;
  if (const int got = snd_pcm_get_params(pcm, &buffer, &period); got < 0)
    return Fail(CauseOf(got), "read its buffer size");
  snd_pcm_sw_params_t* params = nullptr;
  snd_pcm_sw_params_alloca(&params);
  int set = snd_pcm_sw_params_current(pcm, params);
  if (set == 0) set = snd_pcm_sw_params_set_tstamp_mode(pcm, params, SND_PCM_TSTAMP_ENABLE);
  if (set == 0) set = snd_pcm_sw_params_set_tstamp_type(pcm, params, SND_PCM_TSTAMP_TYPE_MONOTONIC);
  // avail_min makes the descriptor ready once a whole period can be moved, not for every single frame.
  if (set == 0) set = snd_pcm_sw_params_set_avail_min(pcm, params, period);
  if (set == 0) set = snd_pcm_sw_params_set_start_threshold(pcm, params, std::min(2 * period, buffer));
  if (set == 0) set = snd_pcm_sw_params(pcm, params);
  if (set < 0) return Fail(CauseOf(set), "set its software parameters");
  return {};
}

// One epoll set for all of the device's descriptors, but for those that epoll refuses (the
// null device's): such a stream is never readable, and its port says so. Playback waits
// for POLLOUT there, and the set turns that into readable.
Result<UniqueFd> MakePollable(snd_pcm_t* pcm) {
  UniqueFd set(::epoll_create1(EPOLL_CLOEXEC));
  if (!set.valid()) return FailErrno("create an epoll set");
  std::array<pollfd, kMostDescriptors> descriptors{};
  const int count = snd_pcm_poll_descriptors(pcm, descriptors.data(), kMostDescriptors);
  for (int n = 0; n < count; ++n) {
    const pollfd& each = descriptors[static_cast<std::size_t>(n)];
    epoll_event event{};
    event.events = static_cast<std::uint32_t>(each.events);
    if (::epoll_ctl(set.get(), EPOLL_CTL_ADD, each.fd, &event) < 0 && errno != EPERM)
      return FailErrno("watch its descriptor");
  }
  return set;
}

// ALSA writes every failure to standard error by itself; the error code that it returns says
// the same, and the log decides which failures people see.
void IgnoreError(const char*, int, const char*, int, const char*, ...) {}

// Each call goes to ALSA as it is.
class RealPcm final : public AlsaPcm {
 public:
  RealPcm(Handle handle, UniqueFd ready, const ports::SoundFormat& format)
      : handle_(std::move(handle)), ready_(std::move(ready)), format_(format) {}

  ports::SoundFormat format() const override { return format_; }
  int pollable() const override { return ready_.get(); }
  int Start() override { return snd_pcm_start(handle_.get()); }
  int Prepare() override { return snd_pcm_prepare(handle_.get()); }
  int Resume() override { return snd_pcm_resume(handle_.get()); }
  int Status(PcmStatus& into) override;
  long Read(std::span<std::int16_t> into) override {
    return snd_pcm_readi(handle_.get(), into.data(), Frames(into.size()));
  }
  long Write(std::span<const std::int16_t> from) override {
    return snd_pcm_writei(handle_.get(), from.data(), Frames(from.size()));
  }

 private:
  // ALSA counts frames, spans count samples.
  unsigned long Frames(std::size_t samples) const {
    return samples / static_cast<std::size_t>(format_.channels);
  }

  Handle handle_;
  UniqueFd ready_;  // Closes before the handle whose descriptors it watches.
  ports::SoundFormat format_;
};

// The stamp is on CLOCK_MONOTONIC, by SetSoftware; the delay is in frames and was true at the stamp.
int RealPcm::Status(PcmStatus& into) {
  snd_pcm_status_t* status = nullptr;
  snd_pcm_status_alloca(&status);
  if (const int got = snd_pcm_status(handle_.get(), status); got < 0) return got;
  snd_htimestamp_t stamp{};
  snd_pcm_status_get_htstamp(status, &stamp);
  into = PcmStatus{};
  into.delay_frames = snd_pcm_status_get_delay(status);
  // ALSA gives a zero stamp where the device has none.
  if (stamp.tv_sec != 0 || stamp.tv_nsec != 0)
    into.at = Time{} + std::chrono::seconds(stamp.tv_sec) + Duration(stamp.tv_nsec);
  return 0;
}

Result<std::unique_ptr<AlsaPcm>> Prepared(Handle handle, const AlsaPreferences& preferences) {
  const auto format = SetHardware(handle.get(), preferences);
  if (!format) return tl::unexpected(format.error());
  if (auto ok = SetSoftware(handle.get()); !ok) return tl::unexpected(ok.error());
  auto ready = MakePollable(handle.get());
  if (!ready) return tl::unexpected(ready.error());
  return std::make_unique<RealPcm>(std::move(handle), std::move(*ready), *format);
}

}  // namespace

Result<std::unique_ptr<AlsaPcm>> OpenAlsaPcm(const std::string& name, Direction direction,
                                             const AlsaPreferences& preferences) {
  // A setting of the whole process; every opening sets the same one.
  snd_lib_error_set_handler(IgnoreError);
  snd_pcm_t* raw = nullptr;
  const auto stream = direction == Direction::kCapture ? SND_PCM_STREAM_CAPTURE : SND_PCM_STREAM_PLAYBACK;
  const int opened = snd_pcm_open(&raw, name.c_str(), stream, SND_PCM_NONBLOCK);
  // Owned before the result is looked at: raw stays null where the opening failed.
  Handle handle(raw);
  if (opened < 0) return Fail(CauseOf(opened), "open sound device " + name);
  auto pcm = Prepared(std::move(handle), preferences);
  if (!pcm) return FailAs(pcm.error(), "sound device " + name + ": " + pcm.error().attempt);
  return pcm;
}

}  // namespace kaori::audio
