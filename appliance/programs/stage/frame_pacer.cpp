#include "appliance/programs/stage/frame_pacer.h"

#include <algorithm>
#include <utility>

namespace kaori::stage {
namespace {

// Of the screen's period; at 60 Hz: 1, 4.2, 0.5 and 2.1 ms.
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

// Clocks of screens are told in whole kHz: a smaller change is none.
bool IsSamePeriod(Duration one, Duration other) {
  return std::chrono::abs(one - other) * 100 < one;
}

}  // namespace

void FramePacer::Forget() {
  last_.reset();
  aimed_.reset();
  drawn_ = 0;
}

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

void FramePacer::Drawn(const Plan& plan, Time done) {
  spent_[drawn_++ % kRemembered] = std::max(done - plan.begin, Duration());
  if (!last_) return;
  aimed_ = plan.presented_at;
  if (plan.presented_at - done < last_->period / kTooClose)
    Widen();
  else
    Narrow();
}

FramePacer::Plan FramePacer::Next(Time now) const {
  if (!last_ || last_->period <= Duration()) return {now, now};
  if (!late_) return {now, BlankAfter(now)};
  // The first blank that a frame begun now would usually reach. The margin never skips a blank.
  const Time presented_at = BlankAfter(now + usual() + last_->period / kLeastMargin);
  return {std::max(now, presented_at - usual() - margin_), presented_at};
}

// At or after `at`, and after the last one.
Time FramePacer::BlankAfter(Time at) const {
  const Duration period = last_->period;
  const auto blanks = (at - last_->at + period - Duration(1)) / period;
  return last_->at + std::max<std::int64_t>(1, blanks) * period;
}

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

void FramePacer::Narrow() {
  const Duration least = last_->period / kLeastMargin;
  const Duration ample = 2 * (longest() - usual()) + least;
  const Duration fast = std::max(margin_ - ample, Duration()) / kNarrowFast;
  margin_ = std::max(margin_ - std::max(fast, last_->period / kWiden / kNarrow), least);
}

void FramePacer::Widen() {
  margin_ = std::min(margin_ + last_->period / kWiden, last_->period);
}

}  // namespace kaori::stage
