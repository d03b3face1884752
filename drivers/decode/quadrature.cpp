#include "drivers/decode/quadrature.h"

#include <utility>

namespace kaori::decode {
namespace {

// Where in its cycle a dial is: A leads B when it is turned clockwise.
unsigned QuarterOf(std::uint32_t levels, std::size_t dial) {
  const unsigned a = levels >> (2 * dial) & 1U;
  const unsigned b = levels >> (2 * dial + 1) & 1U;
  return b == 0 ? a : 3 - a;
}

}  // namespace

// Of edges that the levels have in them the numbers count: what the kernel dropped behind them shows by the next one. A number
// that was due before, of an edge that is newer than the levels, is one that was given up too soon.
bool QuadratureDials::Accept(const DialEdge& edge) {
  if (edge.line >= 2 * kMaxDials) return false;
  const auto ahead = static_cast<std::int32_t>(edge.sequence - next_);
  if (needs_levels_ || edge.at <= resumed_at_) {
    if (ahead >= 0) next_ = edge.sequence + 1;
    return Release();
  }
  if (ahead < 0 || ahead >= static_cast<std::int32_t>(kMostEarly)) return Lose(edge.sequence), false;
  early_[edge.sequence % kMostEarly] = edge;
  const bool turned = Release();
  Expire(edge.at);
  return turned;
}

// An edge that has been waited for lets those behind it go, as far as no number is missing among them.
bool QuadratureDials::Release() {
  bool turned = false;
  for (auto* next = &early_[next_ % kMostEarly]; *next; next = &early_[next_ % kMostEarly]) {
    turned |= Apply(*std::exchange(*next, std::nullopt));
    ++next_;
  }
  return turned;
}

// The oldest of those that wait decides: what it waits for would have been in a thread of the kernel for all that time.
bool QuadratureDials::Expire(Time now) {
  for (const auto& edge : early_)
    if (edge && now - edge->at >= kLongestEarly) return Lose(edge->sequence), true;
  return needs_levels_;
}

// What waited is in the levels that are read next. The numbers go on behind the highest that was seen.
void QuadratureDials::Lose(std::uint32_t sequence) {
  ++gaps_;
  needs_levels_ = true;
  for (const auto& edge : early_)
    if (edge && static_cast<std::int32_t>(edge->sequence - sequence) > 0) sequence = edge->sequence;
  if (static_cast<std::int32_t>(sequence - next_) >= 0) next_ = sequence + 1;
  early_ = {};
}

// One edge changes one line, so that a dial goes one quarter forth or back. An edge to the level that a line
// has already is half of a pair whose other half the interrupt was too slow for: it comes to no turn.
bool QuadratureDials::Apply(const DialEdge& edge) {
  const std::uint32_t bit = std::uint32_t{1} << edge.line;
  const std::uint32_t after = edge.active ? levels_ | bit : levels_ & ~bit;
  if (after == levels_) return false;
  const std::size_t dial = edge.line / 2;
  const bool is_forth = ((QuarterOf(levels_, dial) + 1) & 3U) == QuarterOf(after, dial);
  levels_ = after;
  counts_[dial] =
      static_cast<std::int32_t>(static_cast<std::uint32_t>(counts_[dial]) + (is_forth ? 1U : ~0U));
  return true;
}

void QuadratureDials::Resume(std::uint32_t levels, Time at) {
  levels_ = levels;
  resumed_at_ = at;
  needs_levels_ = false;
}

}  // namespace kaori::decode
