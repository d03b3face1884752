#include "firmware/surface/stick_pod.h"

#include <algorithm>

#include "firmware/surface/flash_store.h"

namespace kaori::surface {
namespace {

// The ends of what reports say: both sides of an axis are alike, -32768 is never said.
constexpr std::int32_t kAxisEnd = 32767;
constexpr std::int32_t kSliderEnd = 65535;
// Of the sixteen switches the first twelve are buttons, the last four the hat.
constexpr unsigned kHatShift = 12;
constexpr std::uint32_t kButtonMask = (1U << wire::kStickPodButtons) - 1;
// Of one axis in flash: three numbers of 16 bits.
constexpr std::size_t kEndsBytes = 6;

// By the four switches of a hat, up 1, right 2, down 4, left 8: two neighbours are the way between them, all
// else is none.
constexpr std::uint8_t kNowhere = wire::kHatCentred;
constexpr std::array<std::uint8_t, 16> kHats{
    kNowhere, 0, 2, 1, 4, kNowhere, 3, kNowhere, 6, 7, kNowhere, kNowhere, 5, kNowhere, kNowhere, kNowhere};

using Stored = std::array<std::uint8_t, StickPod::kAxes * kEndsBytes>;

// Low, centre, high, axis by axis, little-endian.
Stored Encode(const std::array<AxisEnds, StickPod::kAxes>& ends) {
  Stored bytes{};
  for (std::size_t n = 0; n < ends.size(); ++n) {
    wire::PutU16(bytes, kEndsBytes * n, ends[n].low);
    wire::PutU16(bytes, kEndsBytes * n + 2, ends[n].centre);
    wire::PutU16(bytes, kEndsBytes * n + 4, ends[n].high);
  }
  return bytes;
}

}  // namespace

// An axis whose stored ends make no sense keeps the usual ones, and the others theirs.
StickPod::StickPod(const Unit& unit, Updater* updater, Flash* flash)
    : service_(unit, updater), flash_(flash) {
  const auto stored = flash != nullptr ? Load(*flash) : std::nullopt;
  if (!stored || stored->size() != sizeof(Stored)) return;
  for (std::size_t n = 0; n < kAxes; ++n) {
    const AxisEnds ends{.low = wire::GetU16(*stored, kEndsBytes * n),
                        .centre = wire::GetU16(*stored, kEndsBytes * n + 2),
                        .high = wire::GetU16(*stored, kEndsBytes * n + 4)};
    if (IsValid(ends)) ends_[n] = ends;
  }
}

// All filters give a value at the same tick, every fourth, so that the axes of a report belong together.
void StickPod::Tick(std::uint32_t closed, const Codes& codes) {
  log_.Note(switches_.Look(closed & 0xFFFFU), host_ == Host::kThere);
  bool is_new = false;
  for (std::size_t n = 0; n < kAxes; ++n) is_new = filters_[n].Sample(codes[n]);
  if (!is_new) return;
  if (teachers_)
    for (std::size_t n = 0; n < kAxes; ++n) (*teachers_)[n].See(filters_[n].value_q4());
  Follow();
}

// A slider has no middle to rest in: its whole way is one side.
std::int32_t StickPod::Value(std::size_t axis) const {
  const std::uint32_t value_q4 = filters_[axis].value_q4();
  return axis == kSlider ? SliderValue(value_q4, ends_[axis]) : AxisValue(value_q4, ends_[axis]);
}

// Values that move by no more than noise are not followed, or a stick that nobody touches would send reports.
void StickPod::Follow() {
  for (std::size_t n = 0; n < kAxes; ++n) {
    const std::int32_t low = n == kSlider ? 0 : -kAxisEnd;
    has_moved_ |= gates_[n].Accept(Value(n), low, n == kSlider ? kSliderEnd : kAxisEnd);
  }
}

wire::StickPodReport StickPod::Report(std::uint32_t pressed) const {
  return {.x = static_cast<std::int16_t>(gates_[kX].told()),
          .y = static_cast<std::int16_t>(gates_[kY].told()),
          .twist = static_cast<std::int16_t>(gates_[kTwist].told()),
          .slider = static_cast<std::uint16_t>(gates_[kSlider].told()),
          .hat = kHats[pressed >> kHatShift & 0xFU],
          .buttons_down = static_cast<std::uint16_t>(pressed & kButtonMask)};
}

std::optional<wire::StickPodReport> StickPod::NextReport() {
  if (!has_news()) return std::nullopt;
  has_moved_ = false;
  return Report(log_.Next());
}

// GET_REPORT. A pod has no lamps, so there is no output report to ask for; it counts no double steps.
std::size_t StickPod::Answer(ReportKind kind, std::span<std::uint8_t> into) {
  if (kind == ReportKind::kInput) {
    std::ranges::copy(wire::Encode(Standing()), into.begin());
    return wire::kStickPodReportBytes;
  }
  if (kind != ReportKind::kFeature) return 0;
  std::ranges::copy(wire::Encode(service_.Status(0)), into.begin());
  return wire::kSurfaceFeatureBytes;
}

// SET_REPORT. Calibration is the pod's own command, 1 for its beginning and 0 for its end; all others are
// those that every surface has. What is unknown, or of another length, is refused and changes nothing.
bool StickPod::Accept(ReportKind kind, std::span<const std::uint8_t> report) {
  if (kind != ReportKind::kFeature || report.size() != wire::kSurfaceFeatureBytes) return false;
  const auto command = wire::DecodeSurfaceCommand(report.first<wire::kSurfaceFeatureBytes>());
  if (command.operation == wire::SurfaceOperation::kCalibrate)
    return command.number <= 1 && Calibrate(command.number == 1);
  return service_.Accept(command, lamps_);
}

// Between the two commands a person moves every control to its ends. What was learnt counts for all axes or
// for none: one that was not moved is not valid, and a pod that is half taught would be worse than an
// untaught one.
bool StickPod::Calibrate(bool begins) {
  if (begins) {
    teachers_ = {AxisTeacher(filters_[kX].value_q4()), AxisTeacher(filters_[kY].value_q4()),
                 AxisTeacher(filters_[kTwist].value_q4()), AxisTeacher(filters_[kSlider].value_q4())};
    return true;
  }
  if (!teachers_) return false;
  std::array<AxisEnds, kAxes> learnt;
  for (std::size_t n = 0; n < kAxes; ++n) learnt[n] = (*teachers_)[n].ends();
  teachers_.reset();
  // A slider may begin at an end: what counts is its way as a whole.
  learnt[kSlider].centre = static_cast<std::uint16_t>((learnt[kSlider].low + learnt[kSlider].high) / 2);
  if (!std::ranges::all_of(learnt, [](const AxisEnds& ends) { return IsValid(ends); })) return false;
  ends_ = learnt;
  if (flash_ != nullptr) Store(*flash_, Encode(ends_));
  Follow();
  return true;
}

std::size_t StickPod::NextInput(std::span<std::uint8_t> into) {
  const auto report = NextReport();
  if (!report) return 0;
  std::ranges::copy(wire::Encode(*report), into.begin());
  return wire::kStickPodReportBytes;
}

// A host assumes the middle of a control that it was never told of.
void StickPod::SetHost(Host host) {
  if (host == Host::kThere && host_ == Host::kGone) {
    log_.Restart();
    has_moved_ |= std::ranges::any_of(gates_, [](const AxisGate& gate) { return gate.told() != 0; });
  }
  host_ = host;
}

}  // namespace kaori::surface
