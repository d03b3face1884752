#include "appliance/core/linecheck/trace.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kaori::linecheck {

void Way::Begin(float at, Time now) {
  *this = {};
  low_ = high_ = last_ = at;
  moved_at_ = now;
}

// Steps that are too small are not forgotten: a control that creeps has moved once they add up.
void Way::Follow(float at, const Ends& ends, Time now) {
  low_ = std::min(low_, at);
  high_ = std::max(high_, at);
  if (at <= ends.low && !std::exchange(reached_low_, true)) low_first_ = !reached_high_;
  if (at >= ends.high) reached_high_ = true;
  if (std::abs(at - last_) < ends.step) return;
  const int direction = at > last_ ? 1 : -1;
  if (direction == -direction_) NoteTurn(last_, now);
  direction_ = direction;
  last_ = at;
  moved_at_ = now;
}

void Way::NoteTurn(float value, Time now) {
  turns_[turn_count_++ % kTurns] = {now, value};
  if (turn_count_ < kTurns) return;
  const auto [low, high] = std::ranges::minmax(turns_, {}, &Turn::value);
  const Time oldest = turns_[turn_count_ % kTurns].at;
  noisy_ = noisy_ || (now - oldest <= kJitter && high.value - low.value <= kSmall);
}

void Contact::Begin(std::uint32_t pushes, bool down, Time now) {
  *this = {};
  pushes_ = pushes;
  down_ = down;
  changed_at_ = recent_since_ = now;
}

// A push that began and ended between two looks is known by its count alone.
void Contact::Follow(std::uint32_t pushes, bool down, Time now) {
  const std::uint32_t fresh = pushes - std::exchange(pushes_, pushes);
  if (now - recent_since_ > kChatterTime) {
    recent_ = 0;
    recent_since_ = now;
  }
  recent_ += fresh;
  total_ += fresh;
  noisy_ = noisy_ || recent_ >= kChatter;
  used_ = used_ || fresh != 0 || down != down_;
  if (fresh != 0 || down != down_) changed_at_ = now;
  down_ = down;
}

}  // namespace kaori::linecheck
