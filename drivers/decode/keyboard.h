// Decodes a keyboard: reports of the boot protocol, of
// arrays, or with a bit for each key, to keys that are held.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/decode/report_values.h"
#include "drivers/decode/switches.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::decode {

// The newest state of a keyboard: which keys are held, by usage and not by what is printed on them.
struct KeySample {
  Time at{};         // When the newest good report arrived.
  Switches<8> keys;  // Switch u is the key with usage u of HID page 7; modifiers are E0..E7.
};

// Pure: no file descriptor, no clock. It may outlive the device. Layouts (QWERTY, QWERTZ) and
// auto-repeat are not known here: a key is a place on the keyboard.
class KeyboardDecoder {
 public:
  // An identity without a report descriptor counts as a keyboard in the boot protocol. Errors:
  //   invalid_argument  the report descriptor is broken
  //   not_supported     the device is no keyboard
  static Result<KeyboardDecoder> For(const ports::HidIdentity& identity);

  // Decodes one input report and returns the new sample. A report of a keyboard that cannot tell which keys
  // are held (usages 01..03: roll-over and other errors) leaves the keys as they were. Errors:
  //   bad_message  the report is torn, short, long or of an unknown id; the sample stays as it was
  Result<KeySample> Decode(std::span<const std::uint8_t> report, Time at);

  // To be called when the cable was pulled: no key stays held.
  void Release();

  // The newest sample, also after Release.
  const KeySample& sample() const { return sample_; }

 private:
  explicit KeyboardDecoder(ReportLayout layout);
  // Whether the report has a usage of an error in place of keys (HID Usage Tables 1.3, section 10).
  bool is_phantom(const InputReport& report) const;

  // Of the device's own descriptor.
  ReportLayout layout_;
  // All 256 usages of the keyboard page.
  SwitchReader<8> keys_;
  KeySample sample_;
};

}  // namespace kaori::decode
