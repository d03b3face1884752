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

bool Refusal::Accept(ReportKind kind, std::span<const std::uint8_t> report) {
  if (kind != ReportKind::kFeature || report.size() != wire::kSurfaceFeatureBytes) return false;
  return service_.Accept(wire::DecodeSurfaceCommand(report.first<wire::kSurfaceFeatureBytes>()), lamps_);
}

UsbIdentity RefusedIdentity(const UsbIdentity& identity) {
  UsbIdentity refused = identity;
  refused.name = kName;
  refused.report_descriptor = wire::kRefusalDescriptor;
  refused.takes_output = false;
  return refused;
}

}  // namespace kaori::surface
