// A microphone that streams: frames of sound, in order, stamped with the time at which they were heard.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::ports {

struct SoundFormat {
  int rate_hz = 48000;
  int channels = 1;  // 1 or 2; the samples of one frame lie side by side, left first.
  friend bool operator==(const SoundFormat&, const SoundFormat&) = default;
};

struct SoundBlock {
  Time at{};                              // When the first frame was heard, by the source's own stamp.
  bool xrun = false;                      // Frames were lost before the first one.
  std::span<const std::int16_t> samples;  // Whole frames. Borrowed until the next Read or the end.
};

// No call blocks. One thread.
class Microphone {
 public:
  virtual ~Microphone() = default;

  // Readable when Read would give a block, or the microphone is gone. Sources that have no descriptor to wait
  // for never wake anyone: read now and then as well.
  virtual int pollable() const = 0;

  // Does not change.
  virtual SoundFormat format() const = 0;

  // The oldest frames not yet read; read until there are none. Errors:
  //   resource_unavailable_try_again  no frame is waiting; a source that overran goes on by itself
  //   no_such_device                  unplugged; every later call says the same, open anew
  //   io_error                        the stream broke or stood still; as above
  virtual Result<SoundBlock> Read() = 0;
};

// Opens the microphone anew after any fault. Errors: no_such_device, permission_denied,
// device_or_resource_busy, not_supported (no format that we read), io_error.
using MicrophoneOpener = std::function<Result<std::unique_ptr<Microphone>>()>;

}  // namespace kaori::ports
