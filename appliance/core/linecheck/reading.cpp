#include "appliance/core/linecheck/reading.h"

#include "appliance/core/performance/stick_way.h"

namespace kaori::linecheck {
namespace {

// Where a stick is at its end: calibrations and worn springs leave a little of the way.
constexpr float kEnd = 0.9F;
constexpr float kQuarterTurn = 0.25F;

}  // namespace

board::SourceState SourceOfWay(const board::CheckedItem& item, const board::Snapshot& board) {
  return item.kind == board::CheckedKind::kAxis ? board.sticks[item.device].source : board.surface.source;
}

float WayNow(const board::CheckedItem& item, const board::Snapshot& board,
             const std::array<std::int32_t, 8>& began) {
  if (item.kind == board::CheckedKind::kAxis)
    return performance::WayOn(board.sticks[item.device].value, ControlOf(item));
  const board::Surface& surface = board.surface.value;
  const auto turned = static_cast<std::int32_t>(static_cast<std::uint32_t>(surface.counts[item.number]) -
                                                static_cast<std::uint32_t>(began[item.number]));
  return static_cast<float>(turned) / static_cast<float>(surface.counts_per_turn);
}

Way::Ends EndsOf(const board::CheckedItem& item, const board::Snapshot& board) {
  if (item.kind == board::CheckedKind::kDial)
    return {-kQuarterTurn, kQuarterTurn, 0.5F / static_cast<float>(board.surface.value.counts_per_turn)};
  return show::StaysPut(ControlOf(item)) ? Way::Ends{1 - kEnd, kEnd} : Way::Ends{-kEnd, kEnd};
}

}  // namespace kaori::linecheck
