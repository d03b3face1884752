#include "hw-sim/devices/stick_pod.h"

#include <algorithm>
#include <cmath>

namespace kaori::sim {
namespace {

// HID's logical ranges of the axes and the slider.
constexpr float kAxisEnd = 32767;
constexpr float kSliderEnd = 65535;

Report StickPodBytes(const wire::StickPodReport& report) {
  const auto bytes = wire::Encode(report);
  return {bytes.begin(), bytes.end()};
}

// The descriptor's range is even about 0: -32767 to 32767.
std::int16_t AxisCounts(float value) {
  return static_cast<std::int16_t>(std::lround(value * kAxisEnd));
}

// A number that is none leaves the stick where it is.
float Held(float value, float low, float high, float otherwise) {
  return std::isnan(value) ? otherwise : std::clamp(value, low, high);
}

}  // namespace

// Positions may share a report: the newest one counts.
wire::StickPodReport& StickPod::Change() {
  return waiting_.Change(context_.clock.now(), [](const auto&, const auto&) { return false; });
}

void StickPod::Move(float x, float y) {
  x = Held(x, -1, 1, x_);
  y = Held(y, -1, 1, y_);
  if (x == x_ && y == y_) return;
  x_ = x;
  y_ = y;
  auto& report = Change();
  report.x = AxisCounts(x);
  report.y = AxisCounts(-y);  // On the wire Y grows towards the operator.
  context_.Notify({port_, Verb::kMove, 0, x, y});
}

void StickPod::Twist(float twist) {
  twist = Held(twist, -1, 1, twist_);
  if (twist == twist_) return;
  twist_ = twist;
  Change().twist = AxisCounts(twist);
  context_.Notify({port_, Verb::kTwist, 0, twist, 0});
}

void StickPod::Slide(float slider) {
  slider = Held(slider, 0, 1, slider_);
  if (slider == slider_) return;
  slider_ = slider;
  Change().slider = static_cast<std::uint16_t>(std::lround(slider * kSliderEnd));
  context_.Notify({port_, Verb::kSlide, 0, slider, 0});
}

int StickPod::hat() const {
  const int hat = waiting_.newest().hat;
  return hat == wire::kHatCentred ? -1 : hat;
}

void StickPod::Hat(int direction) {
  if (direction < -1 || direction > 7 || direction == hat()) return;
  auto& report = waiting_.Change(context_.clock.now(),
                                 // Up and then left within a millisecond is two reports; two
                                 // positions of an axis are one.
                                 [](const auto& before, const auto& back) { return before.hat != back.hat; });
  report.hat = direction < 0 ? wire::kHatCentred : static_cast<std::uint8_t>(direction);
  context_.Notify({port_, Verb::kHat, direction, 0, 0});
}

void StickPod::Push(int button) {
  SetButton(button, true);
}
void StickPod::Release(int button) {
  SetButton(button, false);
}

void StickPod::SetButton(int button, bool down) {
  if (button < 0 || button >= static_cast<int>(wire::kStickPodButtons)) return;
  const auto bit = static_cast<std::uint16_t>(1u << button);
  if (((buttons_down() & bit) != 0) == down) return;
  // An edge that would undo the edge of the same button before it gets a report of its own.
  auto& report = waiting_.Change(context_.clock.now(), [bit](const auto& before, const auto& back) {
    return ((before.buttons_down ^ back.buttons_down) & bit) != 0;
  });
  report.buttons_down = static_cast<std::uint16_t>(report.buttons_down ^ bit);
  context_.Notify({port_, down ? Verb::kPush : Verb::kRelease, button, 0, 0});
}

HidDeviceName StickPod::device_name() const {
  return {wire::kStickPodVendor, wire::kStickPodProduct, "Kaori stick pod", wire::kStickPodDescriptor};
}

std::optional<Report> StickPod::NextReport(Time now) {
  const auto report = waiting_.Next(now);
  if (!report) return std::nullopt;
  return StickPodBytes(*report);
}

Report StickPod::Standing() const {
  return StickPodBytes(waiting_.newest());
}

// A host assumes the rest of a control that it was never told of: one that is elsewhere is told at once.
void StickPod::HostCame() {
  waiting_.set_hosted(true);
  if (!waiting_.next_due() && Standing() != StickPodBytes({})) Change();
}

}  // namespace kaori::sim
