// A simulated keyboard with n-key rollover: its report has a bit for each key, in the form of the boot
// keyboard of HID 1.11 behind it (firmware/wire/keyboard.h).
#pragma once

#include "firmware/wire/keyboard.h"
#include "hw-sim/devices/hid_device.h"
#include "hw-sim/devices/operator_action.h"
#include "hw-sim/devices/report_queue.h"

namespace kaori::sim {

// A device of its own, beside the real keyboard of the machine that it is simulated on. Nothing repeats
// by itself: auto-repeat is made by hosts. One thread.
// One thread.
class Keyboard final : public HidDevice {
 public:
  // Borrows the context.
  explicit Keyboard(const DeviceContext& context) : context_(context) {}

  // Test's side. `usage` is of HID page 7: 0x04..0xDF keys, 0xE0..0xE7 modifiers; others are ignored.
  void Press(std::uint8_t usage) { Set(usage, true); }
  void Release(std::uint8_t usage) { Set(usage, false); }
  // Whether the key is down now, reported or not.
  bool held(std::uint8_t usage) const { return waiting_.newest().held(usage); }
  std::uint8_t lights() const { return lights_; }  // Bit 0 num lock, 1 caps lock, 2 scroll lock.

  // Appliance's side.
  HidDeviceName device_name() const override;
  std::optional<Time> next_due() const override { return waiting_.next_due(); }
  std::optional<Report> NextReport(Time now) override;
  Report Standing() const override;
  void HandleOutput(std::span<const std::uint8_t> report) override;
  void HostCame() override;
  void HostLeft() override { waiting_.set_hosted(false); }
  void PowerCycle() override;

 private:
  // Keys are states, not events: the next report starts from all of them.
  static wire::KeyboardReport Next(const wire::KeyboardReport& last) { return last; }
  // Presses a key, or releases it; does nothing where it is so already.
  void Set(std::uint8_t usage, bool down);

  const DeviceContext& context_;
  ReportQueue<wire::KeyboardReport> waiting_{&Next};
  // Bits of the last output report.
  std::uint8_t lights_ = 0;
};

}  // namespace kaori::sim
