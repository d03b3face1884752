#include "appliance/core/linecheck/turn_finder.h"

#include <algorithm>

#include "appliance/core/show/roles.h"

namespace kaori::linecheck {
namespace {

using namespace std::chrono_literals;

constexpr Duration kStands = 1500ms;
constexpr std::uint32_t kLeastCounts = 8;       // A coarser dial is none; fewer counts are a touch.
constexpr std::uint32_t kMostCounts = 1 << 20;  // As kaori-input takes them.

// Counts wrap; a difference of a turn does not.
std::uint32_t CountsBetween(std::int32_t from, std::int32_t to) {
  const std::uint32_t way = static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from);
  return static_cast<std::int32_t>(way) < 0 ? 0U - way : way;
}

}  // namespace

// Where the dials stand now is where the first turn begins, however far a device has turned before.
void TurnFinder::Begin(const board::Snapshot& board, Time now) {
  *this = {};
  from_ = last_ = board.surface.value.counts;
  changed_at_ = now;
}

// What a device did while nobody read it is no turn.
void TurnFinder::Look(const board::Snapshot& board, Time now) {
  const Counts& counts = board.surface.value.counts;
  if (board.surface.source != board::SourceState::kLive) {
    from_ = last_ = counts;
    return;
  }
  if (counts != last_) {
    last_ = counts;
    changed_at_ = now;
  }
  if (last_ == from_ || now - changed_at_ < kStands) return;
  Decide();
  from_ = last_;
  changed_at_ = now;
}

// The dial that went furthest, where it is clear which one was meant: a sleeve that touches a neighbour moves it by a few
// counts, and another hand by many. What is too little or too much for a turn changes nothing.
void TurnFinder::Decide() {
  std::array<std::uint32_t, 8> ways{};
  for (std::size_t dial = 0; dial < ways.size(); ++dial) ways[dial] = CountsBetween(from_[dial], last_[dial]);
  const auto* const best = std::ranges::max_element(ways);
  if (*best < kLeastCounts || *best > kMostCounts) return;
  ambiguous_ =
      std::ranges::any_of(ways, [&](const std::uint32_t& way) { return &way != best && way > *best / 10; });
  if (ambiguous_) return;
  found_ = Turn{.dial = {.kind = board::CheckedKind::kDial,
                         .device = static_cast<std::uint32_t>(show::Device::kDialBox),
                         .number = static_cast<std::uint32_t>(best - ways.begin()),
                         .state = board::CheckedState::kSeen},
                .counts = *best};
}

}  // namespace kaori::linecheck
