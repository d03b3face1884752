#include "hw-sim/devices/stick_pod.h"

#include <algorithm>
#include <cmath>

#include "firmware/surface/version.h"
#include "hw-sim/devices/report_queue.h"

namespace kaori::sim {
namespace {

// The ends of a pod that nobody has calibrated.
constexpr surface::AxisEnds kEnds;
// About the middle this part of the way, in sixteenths of a sum, is still the middle
// (firmware/surface/axis.h).
constexpr int kRestOf = 100;
constexpr unsigned kFirstHatSwitch = 12;
// Which switches a hat closes by its direction: up 1, right 2, down 4, left 8.
constexpr std::array<std::uint32_t, 8> kHatSwitches{1, 3, 2, 6, 4, 12, 8, 9};
// How often a switch opens and closes again before it rests.
constexpr unsigned kSwitchChatters = 4;
// Sums until a step from stop to stop has settled: two for the median, 18 halvings, and one to be sure.
constexpr unsigned kSumsToSettle = 21;

Report StickPodBytes(const wire::StickPodReport& report) {
  const auto bytes = wire::Encode(report);
  return {bytes.begin(), bytes.end()};
}

// Where a potentiometer has to stand, so that the firmware says `value`, -1 .. 1.
std::uint16_t AxisSum(float value) {
  const double way = 16.0 * (value < 0 ? kEnds.centre - kEnds.low : kEnds.high - kEnds.centre);
  const double rest = std::floor(way / kRestOf);
  const double away =
      value == 0 ? 0 : std::copysign(rest + std::abs(static_cast<double>(value)) * (way - rest), value);
  return static_cast<std::uint16_t>(std::lround(kEnds.centre + away / 16));
}

std::uint16_t SliderSum(float value) {
  return static_cast<std::uint16_t>(
      std::lround(kEnds.low + static_cast<double>(value) * (kEnds.high - kEnds.low)));
}

// A number that is none leaves the stick where it is.
float Held(float value, float low, float high, float otherwise) {
  return std::isnan(value) ? otherwise : std::clamp(value, low, high);
}

}  // namespace

StickPod::StickPod(DevicePort port, const DeviceContext& context) : port_(port), context_(context) {
  PowerOn();
}

template <class Do>
void StickPod::Change(Do act) {
  const bool had_news = firmware_->has_news();
  act();
  if (!had_news) changed_at_ = context_.clock.now();
}

void StickPod::Look(unsigned looks) {
  for (unsigned look = 0; look < looks; ++look, ++code_of_four_) {
    surface::StickPod::Codes codes;
    // What four codes cannot share evenly the first of them have.
    for (std::size_t n = 0; n < codes.size(); ++n)
      codes[n] = static_cast<std::uint16_t>(sums_[n] / 4 + (code_of_four_ % 4 < sums_[n] % 4U ? 1 : 0));
    firmware_->Tick(closed_, codes);
  }
}

// On the wire Y grows towards the operator.
void StickPod::Settle() {
  sums_ = {AxisSum(x_), AxisSum(-y_), AxisSum(twist_), SliderSum(slider_)};
  Look(4 * kSumsToSettle);
}

void StickPod::Move(float x, float y) {
  x = Held(x, -1, 1, x_);
  y = Held(y, -1, 1, y_);
  if (x == x_ && y == y_) return;
  x_ = x;
  y_ = y;
  Change([this] { Settle(); });
  context_.Notify({port_, Verb::kMove, 0, x, y});
}

void StickPod::Twist(float twist) {
  twist = Held(twist, -1, 1, twist_);
  if (twist == twist_) return;
  twist_ = twist;
  Change([this] { Settle(); });
  context_.Notify({port_, Verb::kTwist, 0, twist, 0});
}

void StickPod::Slide(float slider) {
  slider = Held(slider, 0, 1, slider_);
  if (slider == slider_) return;
  slider_ = slider;
  Change([this] { Settle(); });
  context_.Notify({port_, Verb::kSlide, 0, slider, 0});
}

// A thumb that goes from one way to the next opens the old switch before it closes the new one.
void StickPod::Hat(int direction) {
  if (direction < -1 || direction > 7 || direction == hat_) return;
  const auto switches = [](int way) {
    return way < 0 ? 0U : kHatSwitches[static_cast<std::size_t>(way)] << kFirstHatSwitch;
  };
  const std::uint32_t before = switches(hat_), after = switches(direction);
  hat_ = direction;
  Change([&] {
    if ((before & ~after) != 0) Switch(before & ~after, surface::Buttons::kLooksToRelease);
    if ((after & ~before) != 0) Switch(after & ~before, surface::Buttons::kLooksToPress);
  });
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
  const auto bit = static_cast<std::uint16_t>(1U << static_cast<unsigned>(button));
  if (((buttons_ & bit) != 0) == down) return;
  buttons_ = static_cast<std::uint16_t>(buttons_ ^ bit);
  Change([&] { Switch(bit, down ? surface::Buttons::kLooksToPress : surface::Buttons::kLooksToRelease); });
  context_.Notify({port_, down ? Verb::kPush : Verb::kRelease, button, 0, 0});
}

// Chatters before it settles, so that the firmware's debouncing is tried with each push.
void StickPod::Switch(std::uint32_t changed, unsigned looks) {
  for (unsigned chatter = 0; chatter < kSwitchChatters; ++chatter) {
    closed_ ^= changed;
    Look(1);
  }
  closed_ ^= changed;
  Look(looks);
}

HidDeviceName StickPod::device_name() const {
  return {wire::kStickPodVendor, wire::kStickPodProduct, "Kaori stick pod", wire::kStickPodDescriptor};
}

std::optional<Time> StickPod::next_due() const {
  if (!firmware_->has_news()) return std::nullopt;
  return std::max(changed_at_, free_at_);
}

std::optional<Report> StickPod::NextReport(Time now) {
  const auto due = next_due();
  if (!due || *due > now) return std::nullopt;
  const auto report = firmware_->NextReport();
  if (!report) return std::nullopt;
  changed_at_ = now;
  free_at_ = now + kReportPeriod;
  return StickPodBytes(*report);
}

Report StickPod::Standing() const {
  return StickPodBytes(firmware_->Standing());
}

void StickPod::HostCame() {
  Change([this] { firmware_->SetHost(surface::Host::kThere); });
}

// The switches and potentiometers are as the operator holds them; the firmware learns that by looking.
void StickPod::PowerOn() {
  firmware_.emplace(surface::Unit{.major = surface::kVersionMajor, .minor = surface::kVersionMinor}, nullptr,
                    nullptr);
  Settle();
}

}  // namespace kaori::sim
