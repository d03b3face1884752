#include "drivers/decode/quadrature.h"

namespace kaori::decode {
namespace {

// Where in its cycle a dial is: A leads B when it is turned clockwise.
unsigned QuarterOf(std::uint32_t levels, std::size_t dial) {
  const unsigned a = levels >> (2 * dial) & 1U;
  const unsigned b = levels >> (2 * dial + 1) & 1U;
  return b == 0 ? a : 3 - a;
}

}  // namespace

// One edge changes one line, so that a dial goes one quarter forth or back. An edge to the level that a line
// has already is half of a pair whose other half the interrupt was too slow for: it comes to no turn.
bool QuadratureDials::Accept(const DialEdge& edge) {
  if (edge.line >= 2 * kMaxDials) return false;
  const bool follows = !began_ || edge.sequence == last_sequence_ + 1;
  began_ = true;
  last_sequence_ = edge.sequence;
  if (!follows && !needs_levels_) {
    ++gaps_;
    needs_levels_ = true;
  }
  if (needs_levels_ || edge.at <= resumed_at_) return false;
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
