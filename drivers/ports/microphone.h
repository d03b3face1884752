// A microphone that streams: gives frames of sound in order, stamped with the time at which they were heard.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::ports {

// Signed 16-bit samples in the machine's byte order.
struct SoundFormat {
  int rate_hz = 48000;  // Frames in a second.
  int channels = 1;     // 1 or 2; the samples of one frame are interleaved, left first.
  friend bool operator==(const SoundFormat&, const SoundFormat&) = default;
};

// Frames that were heard one after the other, without a gap inside, lent by the microphone.
struct SoundBlock {
  Time at{};                              // When the first frame was heard, by the source's stamp.
  bool xrun = false;                      // Frames were lost before the first one.
  std::span<const std::int16_t> samples;  // Whole frames. Valid until the next Read or the microphone's end.
};

// A microphone that has been opened and records from then on. Its clock is not the machine's: over an hour the count
// of its frames and CLOCK_MONOTONIC differ by some ten milliseconds, so each block has a stamp. What nobody reads is
// kept by the driver for as long as its buffer has room, and is lost from then on. No call blocks. One thread.
class Microphone {
 public:
  // Stops recording: blocks that were given are gone.
  virtual ~Microphone() = default;

  // A descriptor that is readable when Read would give a block, or when the microphone is gone. It belongs to
  // the microphone. Devices without descriptors never make it readable: call Read now and then as well.
  virtual int pollable() const = 0;

  // Does not change once a block was read.
  virtual SoundFormat format() const = 0;

  // The oldest frames that were not read; call it until there are none. How many frames a block has is the device's
  // choice, usually one period. The block given before ends with this call. Errors:
  //   resource_unavailable_try_again  there is no frame; after an overrun the stream goes on by itself
  //   no_such_device                  the microphone was unplugged
  //   io_error                        the stream broke or stalled
  // After the last two every later call says the same: open the microphone anew.
  virtual Result<SoundBlock> Read() = 0;
};

// Opens the microphone; to be called again after a fault, after the old one has ended. Blocks while the sound card
// answers: some milliseconds. Errors:
//   no_such_device           it is not plugged in
//   permission_denied        it may not be opened
//   device_or_resource_busy  another program uses it
//   not_supported            it has no format that we read
//   io_error                 any other fault
using MicrophoneOpener = std::function<Result<std::unique_ptr<Microphone>>()>;

}  // namespace kaori::ports
