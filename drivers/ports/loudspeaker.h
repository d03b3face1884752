// A loudspeaker that plays what it is given, and tells when each part will be heard.
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

struct Playout {
  std::size_t frames = 0;  // How many were taken; the rest found no room.
  Time at{};               // When the first of them is heard, by the device's own count of what waits.
  bool xrun = false;       // It had run dry before, and was silent meanwhile.
};

// No call blocks. One thread.
class Loudspeaker {
 public:
  virtual ~Loudspeaker() = default;

  // Readable when Write would find room, or the loudspeaker is gone. Devices that have no descriptor to wait
  // for never wake anyone.
  virtual int pollable() const = 0;

  // Does not change.
  virtual SoundFormat format() const = 0;

  // Queues whole frames behind those that wait. Errors:
  //   resource_unavailable_try_again  no room for a frame now
  //   invalid_argument                not whole frames, or none
  //   no_such_device                  unplugged; every later call says the same, open anew
  //   io_error                        the stream broke; as above
  virtual Result<Playout> Write(std::span<const std::int16_t> samples) = 0;
};

// Opens the loudspeaker anew after any fault. Errors: as MicrophoneOpener.
using LoudspeakerOpener = std::function<Result<std::unique_ptr<Loudspeaker>>()>;

}  // namespace kaori::ports
