#include "appliance/programs/stage/frame_pacer.h"

#include <algorithm>
#include <utility>

namespace kaori::stage {
namespace {

// Fractions of the screen's period; at 60 Hz they are 1, 4.2, 0.5 and 2.1 ms. The first margin is wide, since
// nothing is known of a new screen.
constexpr int kLeastMargin = 16;
constexpr int kFirstMargin = 4;
constexpr int kTooClose = 32;  // A frame that is ready so late before its blank was lucky.
constexpr int kWiden = 8;
// The margin widens by a step at each frame that was late or lucky and narrows by this part of a step at each
// other one: so it settles where one frame in so many is one of them.
constexpr int kNarrow = 250;
// But fast, by this part of the difference at each frame, down to twice what any remembered frame needed: a
// machine that was busy once is not late for ever.
constexpr int kNarrowFast = 8;
constexpr std::size_t kNewest = 15;  // Half of them are new within 8 frames of a step.

// Clocks of screens are told in whole kHz: a smaller change is none. A screen that changes its mode sends
// flips of another period: all that was learnt belongs to the old one.
bool IsSamePeriod(Duration one, Duration other) {
  return std::chrono::abs(one - other) * 100 < one;
}

}  // namespace

// The margin stays until the first flip says what the new period is.
void FramePacer::Forget() {
  last_.reset();
  aimed_.reset();
  drawn_ = 0;
}

// A flip that is half a period or more behind its aim came a blank later. The first flip has no aim and is
// never late.
void FramePacer::Flipped(const ports::Flip& flip) {
  if (!last_ || !IsSamePeriod(last_->period, flip.period)) {
    Forget();
    margin_ = flip.period / kFirstMargin;
  }
  const auto aimed = std::exchange(aimed_, std::nullopt);
  last_ = flip;
  if (!aimed || flip.at - *aimed < flip.period / 2) return;
  ++missed_;
  Widen();
}

// The time is counted from the plan's begin and not from when drawing really began: a late waking is part of
// what a frame takes on this machine. Lucky frames widen the margin as missed ones do, so that the pacer
// backs off before the audience sees a miss.
void FramePacer::Drawn(const Plan& plan, Time done) {
  spent_[drawn_++ % kRemembered] = std::max(done - plan.begin, Duration());
  if (!last_) return;
  aimed_ = plan.presented_at;
  if (plan.presented_at - done < last_->period / kTooClose)
    Widen();
  else
    Narrow();
}

// A period of 0 (a screen without blanks, as some virtual ones) is drawn at once, like the first frame.
FramePacer::Plan FramePacer::Next(Time now) const {
  if (!last_ || last_->period <= Duration()) return {now, now};
  if (!late_) return {now, BlankAfter(now)};
  // The first blank that a frame begun now would usually reach. The margin never skips a blank.
  const Time presented_at = BlankAfter(now + usual() + last_->period / kLeastMargin);
  return {std::max(now, presented_at - usual() - margin_), presented_at};
}

// At or after `at`, and after the last one. Blanks are counted from the newest flip, so that the clock of the
// screen and ours cannot drift apart.
Time FramePacer::BlankAfter(Time at) const {
  const Duration period = last_->period;
  const auto blanks = (at - last_->at + period - Duration(1)) / period;
  return last_->at + std::max<std::int64_t>(1, blanks) * period;
}

// The median, since one slow frame (a shader, another program) says nothing of the next; it holds for a fade
// too, in which frames take longer after a few of them.
Duration FramePacer::usual() const {
  std::array<Duration, kNewest> newest;
  const std::size_t count = std::min(drawn_, kNewest);
  if (count == 0) return {};
  for (std::size_t i = 0; i < count; ++i) newest[i] = spent_[(drawn_ - 1 - i) % kRemembered];
  const auto middle = newest.begin() + std::ptrdiff_t(count / 2);
  std::nth_element(newest.begin(), middle, newest.begin() + std::ptrdiff_t(count));
  return *middle;
}

Duration FramePacer::longest() const {
  return *std::max_element(spent_.begin(), spent_.begin() + std::ptrdiff_t(std::min(drawn_, kRemembered)));
}

// Both speeds at once: a slow one that balances with Widen where one frame in 250 is late or lucky, and a
// fast one from a margin that no remembered frame would have needed.
void FramePacer::Narrow() {
  const Duration least = last_->period / kLeastMargin;
  const Duration ample = 2 * (longest() - usual()) + least;
  const Duration fast = std::max(margin_ - ample, Duration()) / kNarrowFast;
  margin_ = std::max(margin_ - std::max(fast, last_->period / kWiden / kNarrow), least);
}

// One period is the most: a margin beyond it would only make the input older.
void FramePacer::Widen() {
  margin_ = std::min(margin_ + last_->period / kWiden, last_->period);
}

}  // namespace kaori::stage
