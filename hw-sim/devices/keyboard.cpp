#include "hw-sim/devices/keyboard.h"

#include <algorithm>

namespace kaori::sim {
namespace {

// The last modifier, right GUI.
constexpr std::uint8_t kLastUsage = 0xE7;
// Num, caps and scroll lock, compose and kana.
constexpr std::uint8_t kLightBits = 0x1F;

Report KeyboardBytes(const wire::KeyboardReport& report) {
  const auto bytes = wire::Encode(report);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

// Usages of the keyboard page (HID Usage Tables, 10). One beyond the keyboard's range is ignored.
void Keyboard::Set(std::uint8_t usage, bool down) {
  if (usage < wire::kFirstKeyUsage || usage > kLastUsage || held(usage) == down) return;
  // A key that went down in the waiting report must not go up in it: a tap would be lost.
  auto& report = waiting_.Change(context_.clock.now(), [usage](const auto& before, const auto& back) {
    return before.held(usage) != back.held(usage);
  });
  report.Hold(usage, down);
  context_.Notify({DevicePort::kKeyboard, down ? Verb::kPush : Verb::kRelease, usage, 0, 0});
}

HidDeviceName Keyboard::device_name() const {
  return {wire::kKeyboardVendor, wire::kKeyboardProduct, "Kaori keyboard", wire::kKeyboardDescriptor};
}

std::optional<Report> Keyboard::NextReport(Time now) {
  const auto report = waiting_.Next(now);
  if (!report) return std::nullopt;
  return KeyboardBytes(*report);
}

Report Keyboard::Standing() const {
  return KeyboardBytes(waiting_.newest());
}

void Keyboard::HandleOutput(std::span<const std::uint8_t> report) {
  // One byte behind a report id of 0.
  if (report.size() == 2 && report[0] == 0) lights_ = report[1] & kLightBits;
}

void Keyboard::HostCame() {
  waiting_.set_hosted(true);
  const auto& down = waiting_.newest().down;
  if (waiting_.next_due() || std::ranges::all_of(down, [](std::uint32_t word) { return word == 0; })) return;
  waiting_.Change(context_.clock.now(), [](const auto&, const auto&) { return false; });
}

void Keyboard::PowerCycle() {
  waiting_.Forget();
  lights_ = 0;
}

}  // namespace kaori::sim
