#include "hw-sim/devices/dial_box.h"

#include <algorithm>
#include <cmath>

#include "firmware/surface/version.h"
#include "hw-sim/devices/report_queue.h"

namespace kaori::sim {
namespace {

Report Bytes(const wire::DialBoxReport& report) {
  const auto bytes = wire::Encode(report);
  return {bytes.begin(), bytes.end()};
}

// Nobody turns a dial further in one action: beyond this a number went wrong.
constexpr double kMostTurns = 1000;
// How often a switch opens and closes again before it rests.
constexpr int kChatters = 4;

}  // namespace

DialBox::DialBox(const DeviceContext& context) : context_(context) {
  PowerOn();
}

template <class Do>
void DialBox::Change(Do act) {
  const bool had_news = firmware_->has_news();
  act();
  if (!had_news) changed_at_ = context_.clock.now();
}

// Turns that are no number, or absurdly many, are ignored: a scenario or a page may say anything.
void DialBox::Turn(int dial, double turns) {
  if (dial < 0 || dial >= static_cast<int>(wire::kDials)) return;
  if (turns == 0 || !(std::abs(turns) <= kMostTurns)) return;
  Dial& shaft = dials_[static_cast<std::size_t>(dial)];
  shaft.turns += turns;
  // Counts follow from where the shaft stands, never from the part that was
  // turned last: no rounding adds up.
  const auto counted = static_cast<std::int64_t>(std::llround(shaft.turns * wire::kDialCountsPerTurn));
  Change([&] { MakeEdges(static_cast<std::size_t>(dial), counted - shaft.edges); });
  context_.Notify({DevicePort::kDialBox, Verb::kTurn, dial, turns, 0});
}

// The firmware's looks are at its lines alone: whatever it counts, it has counted edges.
void DialBox::MakeEdges(std::size_t dial, std::int64_t counts) {
  const std::int64_t step = counts < 0 ? -1 : 1;
  std::int64_t& edges = dials_[dial].edges;
  for (; counts != 0; counts -= step) {
    // An encoder's line trembles before it rests.
    for (const std::int64_t way : {step, -step, step}) {
      edges += way;
      LookAtDials();
    }
  }
}

// The lines as two encoders' contacts would have them, a quarter of a cycle apart (quadrature).
void DialBox::LookAtDials() {
  unsigned lines = 0;
  for (std::size_t n = 0; n < dials_.size(); ++n) {
    // Line A is high in the second and the third quarter of a cycle, line B a quarter later.
    const auto quarter = static_cast<unsigned>(dials_[n].edges & 3);
    const unsigned a = quarter == 1 || quarter == 2 ? 1 : 0;
    const unsigned b = quarter >= 2 ? 1 : 0;
    lines |= (a | b << 1) << (2 * n);
  }
  firmware_->Look(static_cast<surface::DialLines>(lines));
}

void DialBox::LookAtSwitches(std::uint32_t closed, unsigned looks) {
  for (unsigned look = 0; look < looks; ++look) firmware_->Tick(closed);
}

void DialBox::Push(int button) {
  SetButton(button, true);
}
void DialBox::Release(int button) {
  SetButton(button, false);
}

// The switch chatters before it settles, so that the firmware's debouncing is tried with each push.
void DialBox::SetButton(int button, bool down) {
  if (button < 0 || button >= static_cast<int>(wire::kDialBoxButtons)) return;
  const std::uint32_t bit = std::uint32_t{1} << button;
  if (((closed_ & bit) != 0) == down) return;
  Change([&] {
    for (int chatter = 0; chatter < kChatters; ++chatter) LookAtSwitches(closed_ ^= bit, 1);
    closed_ ^= bit;
    LookAtSwitches(closed_, down ? surface::Buttons::kLooksToPress : surface::Buttons::kLooksToRelease);
  });
  context_.Notify({DevicePort::kDialBox, down ? Verb::kPush : Verb::kRelease, button, 0, 0});
}

double DialBox::turned(int dial) const {
  if (dial < 0 || dial >= static_cast<int>(wire::kDials)) return 0;
  return dials_[static_cast<std::size_t>(dial)].turns;
}

HidDeviceName DialBox::device_name() const {
  return {wire::kDialBoxVendor, wire::kDialBoxProduct, "Kaori dial and button box", wire::kDialBoxDescriptor};
}

std::optional<Time> DialBox::next_due() const {
  if (!firmware_->has_news()) return std::nullopt;
  return std::max(changed_at_, free_at_);
}

// As a host polls it: no sooner than a period after the report before.
std::optional<Report> DialBox::NextReport(Time now) {
  const auto due = next_due();
  if (!due || *due > now) return std::nullopt;
  const auto report = firmware_->NextReport();
  if (!report) return std::nullopt;
  changed_at_ = now;
  free_at_ = now + kReportPeriod;
  return Bytes(*report);
}

Report DialBox::Standing() const {
  return Bytes(firmware_->Standing());
}

void DialBox::HandleOutput(std::span<const std::uint8_t> report) {
  // What comes behind a report id of 0 (HidDevice::HandleOutput) the firmware takes or refuses.
  if (report.empty() || report[0] != 0) return;
  firmware_->Accept(surface::ReportKind::kOutput, report.subspan(1));
}

void DialBox::HostCame() {
  Change([&] { firmware_->SetHost(surface::Host::kThere); });
}

// The lines are as the operator holds them; the firmware learns that by looking.
void DialBox::PowerOn() {
  firmware_.emplace(surface::Unit{.major = surface::kVersionMajor,
                                  .minor = surface::kVersionMinor,
                                  .counts_per_turn = wire::kDialCountsPerTurn},
                    nullptr);
  LookAtDials();
  LookAtSwitches(closed_, surface::Buttons::kLooksToPress);
}

}  // namespace kaori::sim
