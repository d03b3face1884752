#include "firmware/surface/refusal.h"

#include <algorithm>

#include "firmware/wire/surface_feature.h"

namespace kaori::surface {
namespace {

constexpr std::string_view kName = "RP2040 older than B2: refused";
constexpr std::uint32_t kOddLamps =
    0x55555555;  // Lamps 1, 3, 5 and so on: they are counted from 1 on the panel.
constexpr std::uint32_t kTicksOfHalf = Refusal::kTicksPerSecond / 2;

}  // namespace

// The counter is of one whole period, so that it never grows beyond what the halves are told by. The lamp test goes
// before the pattern: a technician may want to see every lamp of the box that is to get another chip.
std::uint32_t Refusal::Tick() {
  const bool is_first_half = tick_ < kTicksOfHalf;
  tick_ = tick_ + 1 == 2 * kTicksOfHalf ? 0 : tick_ + 1;
  if (service_.tests_lamps()) return ~std::uint32_t{0};
  return is_first_half ? kOddLamps : ~kOddLamps;
}

// The feature report alone: the descriptor has no other.
std::size_t Refusal::Answer(ReportKind kind, std::span<std::uint8_t> into) {
  if (kind != ReportKind::kFeature) return 0;
  wire::SurfaceStatus status = service_.Status(0);
  status.state = wire::SurfaceState::kRefuses;
  std::ranges::copy(wire::Encode(status), into.begin());
  return wire::kSurfaceFeatureBytes;
}

// SET_REPORT. What a surface without an updater refuses is refused here too: the service has none.
bool Refusal::Accept(ReportKind kind, std::span<const std::uint8_t> report) {
  if (kind != ReportKind::kFeature || report.size() != wire::kSurfaceFeatureBytes) return false;
  return service_.Accept(wire::DecodeSurfaceCommand(report.first<wire::kSurfaceFeatureBytes>()), lamps_);
}

// The identity of before is not kept: what is not named here is the surface's own, the serial number above all.
UsbIdentity RefusedIdentity(const UsbIdentity& identity) {
  UsbIdentity refused = identity;
  refused.name = kName;
  refused.report_descriptor = wire::kRefusalDescriptor;
  refused.takes_output = false;
  return refused;
}

}  // namespace kaori::surface
