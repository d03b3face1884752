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

namespace kaori::audio {

enum class Direction : std::uint8_t { kCapture, kPlayback };

// How a device is set, as near as it can.
struct AlsaPreferences {
  int channels = 1;  // 1 or 2; the other number is used where the device has no such mode.
  Duration period = std::chrono::milliseconds(5);   // From one interrupt of the device to the next.
  Duration buffer = std::chrono::milliseconds(60);  // How much sound is buffered at most.
  Duration stall = std::chrono::seconds(1);  // A capture stream without a frame for so long has broken.
};

struct PcmStatus {
  // When the kernel counted the frames; none: the device has no stamps.
  std::optional<Time> at;
  // Frames between the converter and the program: captured and not read, or written and not played.
  long delay_frames = 0;
};

// As the snd_pcm_ calls of the same names: on failure they return -errno. No call blocks. One thread. The
// destructor closes the device.
class AlsaPcm {
 public:
  virtual ~AlsaPcm() = default;
  virtual ports::SoundFormat format() const = 0;
  virtual int pollable() const = 0;  // Readable when a period was captured, or can be written.
  virtual int Start() = 0;
  virtual int Prepare() = 0;
  virtual int Resume() = 0;
  virtual int Status(PcmStatus& into) = 0;
  // Whole frames of interleaved samples; they return how many frames were read or written.
  virtual long Read(std::span<std::int16_t> into) = 0;
  virtual long Write(std::span<const std::int16_t> from) = 0;
};

// Opens the device `name` ("hw:1", "default") with 16-bit samples at 48 kHz. Errors:
//   no_such_device           there is no such device
//   permission_denied        it may not be opened
//   device_or_resource_busy  another program uses it
//   not_supported            it has other rates or sample formats alone
//   io_error                 any other failure of ALSA
using PcmOpener = std::function<Result<std::unique_ptr<AlsaPcm>>(const std::string& name, Direction direction,
                                                                 const AlsaPreferences& preferences)>;
Result<std::unique_ptr<AlsaPcm>> OpenAlsaPcm(const std::string& name, Direction direction,
                                             const AlsaPreferences& preferences);

// The cause of a call's negative result: no_such_device, device_or_resource_busy, permission_denied,
// not_supported or io_error.
std::errc CauseOf(long answer);

// Recovers a stream after an overrun or underrun (-EPIPE), or after its bus was suspended (-ESTRPIPE);
// `answer` is the failed call's result. Errors:
//   resource_unavailable_try_again  the bus has not resumed yet
//   no_such_device                  the device was unplugged
//   io_error                        the stream cannot be recovered
Result<void> Recover(AlsaPcm& pcm, long answer, const std::string& name);

// How long so many frames last.
inline Duration Span(const ports::SoundFormat& format, long frames) {
  return Duration(frames * 1'000'000'000L / format.rate_hz);
}

}  // namespace kaori::audio
