// A keyboard: reports of the boot protocol, of arrays, or with a bit for each key, to keys that are held.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/decode/report_values.h"
#include "drivers/decode/switches.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::decode {

struct KeySample {
  Time at{};         // When the newest good report arrived.
  Switches<8> keys;  // Switch u is the key with usage u of HID page 7; modifiers are E0..E7.
};

// Pure: no descriptor, no clock. It outlives the device.
class KeyboardDecoder {
 public:
  // An identity without a descriptor is read in the boot protocol. Errors: invalid_argument (the descriptor),
  // not_supported (no keyboard by its descriptor).
  static Result<KeyboardDecoder> For(const ports::HidIdentity& identity);

  // Takes one input report. A keyboard that cannot tell which keys are held (roll-over and other error
  // codes 01..03) leaves the keys as they were. Errors: bad_message  torn, short, long or unknown; the
  // sample stays as it was.
  Result<KeySample> Decode(std::span<const std::uint8_t> report, Time at);

  // The cable was pulled: no key stays held.
  void Release();

  const KeySample& sample() const { return sample_; }

 private:
  explicit KeyboardDecoder(ReportLayout layout);
  bool is_phantom(const InputReport& report) const;

  ReportLayout layout_;
  SwitchReader<8> keys_;
  KeySample sample_;
};

}  // namespace kaori::decode
