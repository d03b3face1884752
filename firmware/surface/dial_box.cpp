#include "firmware/surface/dial_box.h"

#include <algorithm>
#include <limits>

namespace kaori::surface {

// Lamps stay for kTicksToDark after the host has gone. The lamp test lights all of them, whoever is there.
std::uint32_t DialBox::Tick(std::uint32_t closed) {
  log_.Note(buttons_.Look(closed), host_ == Host::kThere);
  if (host_ == Host::kGone && ticks_alone_ < kTicksToDark) ++ticks_alone_;
  const std::uint32_t on = lamps_.Tick();
  if (service_.tests_lamps()) return ~std::uint32_t{0};
  return is_dark() ? 0 : on;
}

std::optional<wire::DialBoxReport> DialBox::NextReport() {
  using Limits = std::numeric_limits<std::int16_t>;
  if (!has_news()) return std::nullopt;
  bool says_something = !log_.empty();
  wire::DialBoxReport report{.buttons_down = log_.Next()};
  // Read before the positions: what is counted meanwhile is news again.
  told_steps_ = dials_.steps();
  has_rest_ = false;
  for (std::size_t n = 0; n < told_.size(); ++n) {
    // What does not fit into 16 bits goes into the next report.
    const auto ahead = static_cast<std::int32_t>(dials_.position(n) - told_[n]);
    const auto turned = std::clamp<std::int32_t>(ahead, Limits::min(), Limits::max());
    report.turned[n] = static_cast<std::int16_t>(turned);
    told_[n] += static_cast<std::uint32_t>(turned);
    has_rest_ |= turned != ahead;
    says_something |= turned != 0;
  }
  if (!says_something) return std::nullopt;
  return report;
}

// GET_REPORT: input as things stand, output as the lamps were set, feature as the status of the whole device.
std::size_t DialBox::Answer(ReportKind kind, std::span<std::uint8_t> into) {
  if (kind == ReportKind::kInput) {
    std::ranges::copy(wire::Encode(Standing()), into.begin());
    return wire::kDialBoxReportBytes;
  }
  if (kind == ReportKind::kOutput) {
    std::ranges::copy(wire::EncodeLamps(lamps_.lit()), into.begin());
    return wire::kDialBoxLampBytes;
  }
  std::ranges::copy(wire::Encode(service_.Status(dials_.double_steps())), into.begin());
  return wire::kSurfaceFeatureBytes;
}

// SET_REPORT. A report of another length than the descriptor says is refused whole.
bool DialBox::Accept(ReportKind kind, std::span<const std::uint8_t> report) {
  if (kind == ReportKind::kOutput && report.size() == wire::kDialBoxLampBytes) {
    lamps_.set_lit(wire::DecodeLamps(report.first<wire::kDialBoxLampBytes>()));
    return true;
  }
  if (kind == ReportKind::kFeature && report.size() == wire::kSurfaceFeatureBytes)
    return service_.Accept(wire::DecodeSurfaceCommand(report.first<wire::kSurfaceFeatureBytes>()), lamps_);
  return false;
}

std::size_t DialBox::NextInput(std::span<std::uint8_t> into) {
  const auto report = NextReport();
  if (!report) return 0;
  std::ranges::copy(wire::Encode(*report), into.begin());
  return wire::kDialBoxReportBytes;
}

// A host that comes back is told how the buttons stand; turns that were made without one are told as well,
// since the positions that reports have told do not change meanwhile.
void DialBox::SetHost(Host host) {
  if (host == Host::kThere && host_ == Host::kGone) log_.Restart();
  if (host == Host::kGone && host_ != Host::kGone) ticks_alone_ = 0;
  host_ = host;
}

}  // namespace kaori::surface
