#include "hw-sim/devices/loudspeaker.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace kaori::sim {
namespace {

constexpr std::size_t kMostHeard = 4000;  // Blocks; a block is what was heard between two looks.

}  // namespace

std::vector<Loudspeaker::Heard> Loudspeaker::DrainHeard() {
  std::vector<Heard> taken(std::make_move_iterator(heard_.begin()), std::make_move_iterator(heard_.end()));
  heard_.clear();
  return taken;
}

void Loudspeaker::Stall(bool stalled) {
  if (std::exchange(stalled_, stalled) == stalled) return;
  if (stalled) PlayUntil(context_.clock.now());
  playing_ = false;
  context_.Notify({DevicePort::kLoudspeaker, Verb::kStall, stalled ? 1 : 0, 0, 0});
}

// What came while the simulator was busy came in time: it is played before anything is called dry. A
// driver's packet may lie unread for a while.
void Loudspeaker::Play(std::span<const std::int16_t> samples, Time now) {
  const std::size_t room = kRoomFrames + Due(now), waits = waiting_.size() / kChannels;
  const std::size_t frames = samples.size() / kChannels,
                    taken = std::min(frames, room - std::min(waits, room));
  waiting_.insert(waiting_.end(), samples.begin(),
                  samples.begin() + static_cast<std::ptrdiff_t>(taken * kChannels));
  lost_ += frames - taken;
  if (playing_ || stalled_ || waiting_.empty()) return;
  playing_ = true;
  start_ = played_at_ = now;
  start_frame_ = played_;
}

std::size_t Loudspeaker::Due(Time now) const {
  if (!playing_ || stalled_ || now <= start_) return 0;
  // Counted from the start of this stretch, so that no rounding adds up.
  return start_frame_ + static_cast<std::uint64_t>(Seconds(now - start_) * rate_hz()) - played_;
}

void Loudspeaker::PlayUntil(Time now) {
  const std::size_t due = Due(now), there = waiting_.size() / kChannels;
  Remember(std::min(due, there));
  if (due <= there) return;
  ++dry_;
  playing_ = false;
  level_db_ = -100;
}

void Loudspeaker::Remember(std::size_t frames) {
  if (frames == 0) return;
  const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(frames * kChannels);
  Heard heard{played_at_, 1 / rate_hz(), {waiting_.begin(), end}};
  waiting_.erase(waiting_.begin(), end);
  double power = 0;
  for (const std::int16_t sample : heard.samples) power += double{1} * sample * sample;
  // Full scale is 32768: the mean square as a part of it.
  power /= static_cast<double>(heard.samples.size()) * 32768 * 32768;
  level_db_ = std::max(-100.0, 10 * std::log10(std::max(power, 1e-10)));
  heard_.push_back(std::move(heard));
  if (heard_.size() > kMostHeard) heard_.pop_front();
  played_ += frames;
  played_at_ = start_ + FromSeconds(static_cast<double>(played_ - start_frame_) / rate_hz());
}

void Loudspeaker::Silence() {
  waiting_.clear();
  playing_ = false;
  played_ = start_frame_ = lost_ = 0;
  level_db_ = -100;
}

}  // namespace kaori::sim
