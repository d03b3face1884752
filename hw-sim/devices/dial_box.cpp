#include "hw-sim/devices/dial_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kaori::sim {
namespace {

Report Bytes(const wire::DialBoxReport& report) {
  const auto bytes = wire::Encode(report);
  return {bytes.begin(), bytes.end()};
}

// Nobody turns a dial further in one action: beyond this a number went wrong.
constexpr double kMostTurns = 1000;

}  // namespace

void DialBox::Turn(int dial, double turns) {
  if (dial < 0 || dial >= static_cast<int>(wire::kDials)) return;
  if (turns == 0 || !(std::abs(turns) <= kMostTurns)) return;
  Dial& shaft = dials_[static_cast<std::size_t>(dial)];
  shaft.turns += turns;
  // Counts follow from where the shaft stands, never from the part that was
  // turned last: no rounding adds up.
  const auto counted = static_cast<std::int64_t>(std::llround(shaft.turns * wire::kDialCountsPerTurn));
  AddCounts(dial, counted - shaft.reported);
  shaft.reported = counted;
  context_.Notify({DevicePort::kDialBox, Verb::kTurn, dial, turns, 0});
}

// A report carries 16 bits for each dial: what does not fit goes into the next one.
void DialBox::AddCounts(int dial, std::int64_t counts) {
  using Limits = std::numeric_limits<std::int16_t>;
  const auto n = static_cast<std::size_t>(dial);
  while (counts != 0) {
    // A report whose dial is at its end cannot hold more turns: the rest begins another one.
    auto& report = waiting_.Change(context_.clock.now(), [&](const auto&, const auto& back) {
      return back.turned[n] == Limits::max() || back.turned[n] == Limits::min();
    });
    const std::int64_t before = report.turned[n];
    const std::int64_t after = std::clamp<std::int64_t>(before + counts, Limits::min(), Limits::max());
    if (after == before) return;  // Nobody listens and the report is full: the rest is lost, as by the part.
    report.turned[n] = static_cast<std::int16_t>(after);
    counts -= after - before;
  }
}

void DialBox::Push(int button) {
  SetButton(button, true);
}
void DialBox::Release(int button) {
  SetButton(button, false);
}

void DialBox::SetButton(int button, bool down) {
  if (button < 0 || button >= static_cast<int>(wire::kDialBoxButtons)) return;
  const std::uint32_t bit = std::uint32_t{1} << button;
  if (((buttons_down() & bit) != 0) == down) return;
  // A button that went down in the waiting report must not go up in it: the
  // pair would cancel out and be lost.
  auto& report = waiting_.Change(context_.clock.now(), [bit](const auto& before, const auto& back) {
    return ((before.buttons_down ^ back.buttons_down) & bit) != 0;
  });
  report.buttons_down ^= bit;
  context_.Notify({DevicePort::kDialBox, down ? Verb::kPush : Verb::kRelease, button, 0, 0});
}

double DialBox::turned(int dial) const {
  if (dial < 0 || dial >= static_cast<int>(wire::kDials)) return 0;
  return dials_[static_cast<std::size_t>(dial)].turns;
}

HidDeviceName DialBox::device_name() const {
  return {wire::kDialBoxVendor, wire::kDialBoxProduct, "Kaori dial and button box", wire::kDialBoxDescriptor};
}

std::optional<Report> DialBox::NextReport(Time now) {
  const auto report = waiting_.Next(now);
  if (!report) return std::nullopt;
  return Bytes(*report);
}

Report DialBox::Standing() const {
  return Bytes(Next(waiting_.newest()));
}

void DialBox::HandleOutput(std::span<const std::uint8_t> report) {
  // 4 bytes behind a report id of 0 (HidDevice::HandleOutput). Whatever else comes is no lamps' report.
  if (report.size() != 1 + wire::kDialBoxLampBytes || report[0] != 0) return;
  lamps_ = wire::DecodeLamps(report.subspan<1, wire::kDialBoxLampBytes>());
}

void DialBox::HostCame() {
  waiting_.set_hosted(true);
  // A real box sends its first report when something changes; a button that is
  // held at power-on is such a change.
  if (!waiting_.next_due() && buttons_down() != 0) {
    waiting_.Change(context_.clock.now(), [](const auto&, const auto&) { return false; });
  }
}

void DialBox::PowerCycle() {
  waiting_.Forget();
  lamps_ = 0;
}

}  // namespace kaori::sim
