#include "appliance/core/showlog/recorder.h"

#include <cstring>
#include <utility>

#include "appliance/core/showlog/change.h"
#include "appliance/core/showlog/output_sum.h"
#include "firmware/wire/bytes.h"

namespace kaori::showlog {
namespace {

constexpr StateWords kNoState{};

}  // namespace

Recorder::Recorder(std::function<void()> ask) : ask_(std::move(ask)) {
  for (auto& buffer : buffers_) buffer.resize(kMostChunk_bytes);
}

// The time is asked first: a screen may have been away for long.
void Recorder::Note(const Given& given, const performance::Performed& made) {
  if (frames_ > 0 && (given.presented_at - first_ >= kChunkTime || room().size() < kMostFrame_bytes)) Close();
  if (frames_ == 0) {
    first_ = given.presented_at;
    before_ = now_ = {};
    times_ = {};
    if (given.changed) continues_ = false;
  }
  Append(given, frames_ == 0 || given.changed, OutputSum(made));
  ++frames_;
}

// Events that the board gives are not written, since the replay makes them again; the first frame of a chunk
// has none before it to count from, and writes them always.
void Recorder::Append(const Given& given, bool with_state, std::uint16_t sum) {
  PackFrame(given.presented_at, given.board, times_, now_);
  const bool follow = FollowFromBoard(given) && frames_ > 0;
  if (!follow) PackEvents(given.state.seen, given.events, now_);
  const std::span<std::uint8_t> into = room();
  into[0] = static_cast<std::uint8_t>((with_state ? kWithState : 0U) | (follow ? kEventsOfBoard : 0U));
  std::size_t at = 1;
  at += WriteChange(before_, now_, into.subspan(at));
  if (with_state) {
    PackState(given.state, state_);
    at += WriteChange(kNoState, state_, into.subspan(at));
  }
  wire::PutU16(into, at, sum);
  bytes_ += at + 2;
  before_ = now_;
}

// Neither the editor nor a calibration has taken anything out, and the board is no other one: so it is in a
// show.
bool Recorder::FollowFromBoard(const Given& given) {
  performance::SeenInput seen = seen_;
  seen_ = given.state.seen;
  const performance::InputEvents events = performance::ReadEvents(seen, given.board);
  // Bits and not numbers: -0 is another word than 0. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  return std::memcmp(&seen, &seen_, sizeof(seen)) == 0 && IsSame(events, given.events);
}

// What cannot be handed over is lost, and the next chunk cannot go on from it.
void Recorder::Close() {
  if (frames_ == 0) return;
  const bool free = handed_bytes_.load(std::memory_order_acquire) == 0;
  if (free) {
    const auto chunk = std::span(buffers_[filling_]).first(kChunkHead_bytes + bytes_);
    SealChunk({.number = number_++,
               .bytes = static_cast<std::uint32_t>(bytes_),
               .frames = frames_,
               .flags = continues_ ? kContinues : 0,
               .lost_frames = lost_frames_,
               .first = first_},
              chunk);
    handed_ = std::exchange(filling_, 1 - filling_);
    handed_bytes_.store(chunk.size(), std::memory_order_release);
    ask_();
  }
  lost_frames_ = free ? 0 : lost_frames_ + frames_;
  continues_ = free;
  bytes_ = 0;
  frames_ = 0;
}

// For the writer's thread. The acquire pairs with the release in Close: the chunk's bytes and
// handed_ are whole by then.
std::span<const std::uint8_t> Recorder::handed() const {
  const std::size_t bytes = handed_bytes_.load(std::memory_order_acquire);
  if (bytes == 0) return {};
  return std::span(buffers_[handed_]).first(bytes);
}

}  // namespace kaori::showlog
