#include "hw-sim/devices/pointer.h"

#include <algorithm>
#include <cmath>

namespace kaori::sim {
namespace {

// Nobody rolls a wheel further in one action: beyond this a number went wrong.
constexpr double kMostNotches = 1000;

Report PointerBytes(const wire::PointerReport& report) {
  const auto bytes = wire::Encode(report);
  return {bytes.begin(), bytes.end()};
}

// 0 .. 1 to HID's 0 .. 65535.
std::uint16_t Counts(double port) {
  return static_cast<std::uint16_t>(std::lround(port * wire::kPointerEnd));
}

// A number that is none leaves the pen where it is.
double Held(double value, double otherwise) {
  return std::isnan(value) ? otherwise : std::clamp(value, 0.0, 1.0);
}

// For changes that may always share a report.
bool MergesAlways(const wire::PointerReport&, const wire::PointerReport&) {
  return false;
}

}  // namespace

wire::PointerReport Pointer::Next(const wire::PointerReport& last) {
  return {.buttons_down = last.buttons_down, .x = last.x, .y = last.y};
}

// What was pressed or let go at a position was so there: a report that waits with an edge is not moved on.
void Pointer::Move(double x, double y) {
  x = Held(x, x_);
  y = Held(y, y_);
  if (x == x_ && y == y_) return;
  x_ = x;
  y_ = y;
  auto& report = waiting_.Change(context_.clock.now(), [](const auto& before, const auto& back) {
    return before.buttons_down != back.buttons_down;
  });
  report.x = Counts(x);
  report.y = Counts(y);
  context_.Notify({DevicePort::kPointer, Verb::kMove, 0, x, y});
}

void Pointer::Push(int button) {
  SetButton(button, true);
}
void Pointer::Release(int button) {
  SetButton(button, false);
}

void Pointer::SetButton(int button, bool down) {
  if (button < 0 || button >= static_cast<int>(wire::kPointerButtons)) return;
  const auto bit = static_cast<std::uint8_t>(1U << button);
  if (((buttons_down() & bit) != 0) == down) return;
  auto& report = waiting_.Change(context_.clock.now(), [bit](const auto& before, const auto& back) {
    return ((before.buttons_down ^ back.buttons_down) & bit) != 0;
  });
  report.buttons_down = static_cast<std::uint8_t>(report.buttons_down ^ bit);
  context_.Notify({DevicePort::kPointer, down ? Verb::kPush : Verb::kRelease, button, 0, 0});
}

// Wheels report whole notches; what is left of a part waits for the next turn.
void Pointer::Roll(double notches) {
  if (notches == 0 || !(std::abs(notches) <= kMostNotches)) return;
  unrolled_ += notches;
  // Towards 0 either way: the part that is left has the sign of the turn.
  const double whole = std::trunc(unrolled_);
  unrolled_ -= whole;
  AddNotches(static_cast<int>(whole));
  context_.Notify({DevicePort::kPointer, Verb::kRoll, 0, notches, 0});
}

// A report carries so many notches: what does not fit goes into the next one.
void Pointer::AddNotches(int notches) {
  constexpr int kMost = wire::kPointerMostNotches;
  while (notches != 0) {
    auto& report = waiting_.Change(context_.clock.now(), [](const auto&, const auto& back) {
      return std::abs(int{back.wheel}) == kMost;
    });
    const int after = std::clamp(report.wheel + notches, -kMost, kMost);
    if (after == report.wheel) return;  // Nobody listens and the report is full: the rest is lost.
    notches -= after - report.wheel;
    report.wheel = static_cast<std::int8_t>(after);
  }
}

HidDeviceName Pointer::device_name() const {
  return {wire::kPointerVendor, wire::kPointerProduct, "Kaori tablet", wire::kPointerDescriptor};
}

std::optional<Report> Pointer::NextReport(Time now) {
  const auto report = waiting_.Next(now);
  if (!report) return std::nullopt;
  return PointerBytes(*report);
}

Report Pointer::Standing() const {
  return PointerBytes(Next(waiting_.newest()));
}

void Pointer::HostCame() {
  waiting_.set_hosted(true);
  if (!waiting_.next_due() && Standing() != PointerBytes({}))
    waiting_.Change(context_.clock.now(), MergesAlways);
}

}  // namespace kaori::sim
