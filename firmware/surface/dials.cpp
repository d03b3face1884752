#include "firmware/surface/dials.h"

namespace kaori::surface {
namespace {

// What a step from the state in the row to the state in the column counts; a state is A + 2 B. Clockwise A
// comes first: 0, 1, 3, 2. kDouble: two counts, and either way is as likely.
constexpr std::int8_t kDouble = 2;
constexpr std::int8_t kSteps[4][4] = {
    {0, +1, -1, kDouble},
    {-1, 0, kDouble, +1},
    {+1, kDouble, 0, -1},
    {kDouble, -1, +1, 0},
};

// This core has no atomic addition; only the looking side writes.
void Add(std::atomic<std::uint32_t>& counter, std::uint32_t counts) {
  counter.store(counter.load(std::memory_order_relaxed) + counts, std::memory_order_relaxed);
}

}  // namespace

// In the interrupt, 40 000 times a second: most looks end at the comparison of all lines at once. Positions
// are unknown before the first look, so that it counts nothing.
void Dials::Look(DialLines lines) {
  if (!looked_) {
    before_ = lines;
    looked_ = true;
  }
  // Almost every look sees nothing new.
  unsigned changed = static_cast<unsigned>(lines ^ before_);
  if (changed == 0) return;
  unsigned before = before_;
  unsigned now = lines;
  before_ = lines;
  for (std::size_t dial = 0; changed != 0; ++dial) {
    if ((changed & 3U) != 0) Step(dial, before & 3U, now & 3U);
    changed >>= 2;
    before >>= 2;
    now >>= 2;
  }
}

// Where both lines changed the position stays, and only the counter of double steps moves. `steps_` is
// written last and with release: who reads it with acquire sees the positions that it stands for.
void Dials::Step(std::size_t dial, unsigned before, unsigned now) {
  const std::int8_t step = kSteps[before][now];
  if (step == kDouble) {
    Add(double_steps_, 1);
  } else {
    Add(dials_[dial].position, static_cast<std::uint32_t>(std::int32_t{step}));
    steps_.store(steps_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }
}

}  // namespace kaori::surface
