// One open sound device by its calls: ALSA's, or a test's.
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

struct AlsaWish {
  int channels = 1;  // Another number is taken where the device has no such mode.
  Duration period = std::chrono::milliseconds(5);   // How often the device speaks.
  Duration buffer = std::chrono::milliseconds(60);  // How late we may be.
  Duration stall = std::chrono::seconds(1);         // A microphone that is silent this long has broken.
};

// `delay_frames`: from the converter to us (capture), or from us to the converter (playback), at `at`.
struct PcmStatus {
  std::optional<Time> at;  // None: the device does not stamp.
  long delay_frames = 0;
};

// As the ALSA calls of the same names: failures are -errno. No call blocks. Ends by closing.
class AlsaPcm {
 public:
  virtual ~AlsaPcm() = default;
  virtual ports::SoundFormat format() const = 0;
  virtual int pollable() const = 0;  // Readable when the device is ready.
  virtual int Start() = 0;
  virtual int Prepare() = 0;
  virtual int Resume() = 0;
  virtual int Status(PcmStatus& into) = 0;
  virtual long Read(std::span<std::int16_t> into) = 0;         // Frames.
  virtual long Write(std::span<const std::int16_t> from) = 0;  // Frames.
};

// Opens device `name` ("hw:1", "default") in 16 bit at 48 kHz. Errors: no_such_device, permission_denied,
// device_or_resource_busy, not_supported (other rates or sample formats alone), io_error.
using PcmOpener = std::function<Result<std::unique_ptr<AlsaPcm>>(const std::string& name, Direction direction,
                                                                 const AlsaWish& wish)>;
Result<std::unique_ptr<AlsaPcm>> OpenAlsaPcm(const std::string& name, Direction direction,
                                             const AlsaWish& wish);

// What a negative answer of a call means for its stream: no_such_device, device_or_resource_busy,
// permission_denied, not_supported or io_error.
std::errc CauseOf(long answer);

// Brings a stream back that overran, ran dry (-EPIPE) or slept (-ESTRPIPE); `answer` is what a call said.
// Errors: resource_unavailable_try_again (still waking), no_such_device, io_error.
Result<void> Recover(AlsaPcm& pcm, long answer, const std::string& name);

// How long `frames` sound, at 48 kHz or what the format says.
inline Duration Span(const ports::SoundFormat& format, long frames) {
  return Duration(frames * 1'000'000'000L / format.rate_hz);
}

}  // namespace kaori::audio
