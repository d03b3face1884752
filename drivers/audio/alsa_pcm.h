// One open sound device by the calls that we need: ALSA's, or those of a fake device in tests.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/microphone.h"

// The interface between the streams of this folder and ALSA.
namespace kaori::audio {

// Seen from the program: captured sound is read, playback is written.
enum class Direction : std::uint8_t { kCapture, kPlayback };

// How a device is set, as near as it can.
struct AlsaPreferences {
  int channels = 1;  // 1 or 2; the other number is used where the device has no such mode.
  // Short periods make the delay short, a long buffer forgives a program
  // that is late: 60 ms are three frames of a show.
  Duration period = std::chrono::milliseconds(5);   // From one interrupt of the device to the next.
  Duration buffer = std::chrono::milliseconds(60);  // How much sound is buffered at most.
  Duration stall = std::chrono::seconds(1);  // A capture stream without a frame for so long has broken.
};

// What snd_pcm_status(3) tells of a stream in one call, so that count and stamp belong together.
struct PcmStatus {
  // When the kernel counted the frames; none: the device has no stamps.
  std::optional<Time> at;
  // Frames between the converter and the program: captured and not read, or written and not played.
  long delay_frames = 0;
};

// As the snd_pcm_ calls of the same names: on failure they return -errno, which
// Recover and CauseOf read. No call blocks (SND_PCM_NONBLOCK). One thread. The
// destructor closes the device; what is queued is dropped.
class AlsaPcm {
 public:
  // Every call is one of ALSA's; the device ends with the object.
  virtual ~AlsaPcm() = default;
  // What the device was set to; it does not change.
  virtual ports::SoundFormat format() const = 0;
  virtual int pollable() const = 0;  // Readable when a period was captured, or can be written.
  // Starts a stream that was prepared; a capture stream records from then on. Playback starts by itself.
  virtual int Start() = 0;
  // Makes a stream that was stopped by an overrun or underrun ready again. What was queued is gone.
  virtual int Prepare() = 0;
  // Takes a suspended stream up where it was; -ENOSYS where the hardware cannot,
  // -EAGAIN while it is still suspended.
  virtual int Resume() = 0;
  // What the kernel counts at this moment. A stream that is not running has a delay of 0.
  virtual int Status(PcmStatus& into) = 0;
  // Whole frames of interleaved samples; they return how many frames were read or
  // written, which may be fewer than asked for. -EAGAIN: none now. -EPIPE: an overrun or
  // underrun stopped the stream. -ESTRPIPE: it is suspended.
  virtual long Read(std::span<std::int16_t> into) = 0;
  virtual long Write(std::span<const std::int16_t> from) = 0;
};

// A device that has neither one nor two channels at this rate is refused
// rather than resampled: "plughw:1" lets ALSA convert.
// Opens the device `name` ("hw:1", "default") with 16-bit samples at 48 kHz. Errors:
//   no_such_device           there is no such device
//   permission_denied        it may not be opened
//   device_or_resource_busy  another program uses it
//   not_supported            it has other rates or sample formats alone
//   io_error                 any other failure of ALSA
using PcmOpener = std::function<Result<std::unique_ptr<AlsaPcm>>(const std::string& name, Direction direction,
                                                                 const AlsaPreferences& preferences)>;
// The machine's opener: blocks for some milliseconds while the card is asked for its modes.
Result<std::unique_ptr<AlsaPcm>> OpenAlsaPcm(const std::string& name, Direction direction,
                                             const AlsaPreferences& preferences);

// The cause of a call's negative result: no_such_device, device_or_resource_busy,
// permission_denied, not_supported or io_error for everything else. Of -EPIPE and
// -ESTRPIPE it knows nothing: those are for Recover.
std::errc CauseOf(long answer);

// Recovers a stream after an overrun or underrun (-EPIPE), or after its bus was suspended (-ESTRPIPE);
// `answer` is the failed call's result. Afterwards a capture stream must be started again, unless it
// resumed; playback starts by itself. Every other answer is translated to its error. Errors:
//   resource_unavailable_try_again  the bus has not resumed yet
//   no_such_device                  the device was unplugged
//   io_error                        the stream cannot be recovered
Result<void> Recover(AlsaPcm& pcm, long answer, const std::string& name);

// How long so many frames last, rounded toward zero. Exact for any stream: 2^63 ns are reached only
// after 53 hours at a rate of 48 kHz, and delays are far shorter.
inline Duration Span(const ports::SoundFormat& format, long frames) {
  return Duration(frames * 1'000'000'000L / format.rate_hz);
}

}  // namespace kaori::audio
