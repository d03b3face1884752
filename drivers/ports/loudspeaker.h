// A loudspeaker: queues frames of sound, and tells when each will be heard.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/ports/microphone.h"

namespace kaori::ports {

// What a Write has queued. The show's mouth is animated by `at`, so that lips and sound meet at the loudspeaker. A
// value: it refers to nothing.
struct Playout {
  std::size_t frames = 0;  // How many were queued, from the first on; there was no room for the rest.
  Time at{};          // When the first of them is heard, by the device's count of what is queued before it.
  bool xrun = false;  // The queue had run empty before: nothing was heard meanwhile.
};

// A loudspeaker that has been opened. It plays what is queued at its own clock's rate, and silence where
// the queue runs empty. What is queued at its end is cut off. No call blocks. One thread.
class Loudspeaker {
 public:
  // Cuts off what is queued.
  virtual ~Loudspeaker() = default;

  // A descriptor that is readable when Write would queue frames, or when the loudspeaker is gone. It belongs
  // to the loudspeaker. Devices without descriptors never make it readable: call Write now and then as well.
  virtual int pollable() const = 0;

  // The rate and the channels that Write expects; nothing is converted here. Does not change once a frame was queued.
  virtual SoundFormat format() const = 0;

  // Queues whole frames of interleaved samples behind those that are queued. Less than all may be
  // queued: write the rest when pollable() is readable. `samples` is not used after the call. Errors:
  //   resource_unavailable_try_again  there is no room for a frame now
  //   invalid_argument                `samples` is empty, or no whole number of frames
  //   no_such_device                  the loudspeaker was unplugged
  //   io_error                        the stream broke
  // After the last two every later call says the same: open the loudspeaker anew.
  virtual Result<Playout> Write(std::span<const std::int16_t> samples) = 0;
};

// Opens the loudspeaker; to be called again after a fault. Errors: as MicrophoneOpener.
using LoudspeakerOpener = std::function<Result<std::unique_ptr<Loudspeaker>>()>;

}  // namespace kaori::ports
