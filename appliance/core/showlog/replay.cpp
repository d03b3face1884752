#include "appliance/core/showlog/replay.h"

#include <fmt/format.h>

#include "appliance/core/showlog/change.h"
#include "appliance/core/showlog/output_sum.h"
#include "firmware/wire/bytes.h"

namespace kaori::showlog {

// A replay can only begin where a chunk does, whose first frame has a whole state: that is up to a chunk's
// length before `at`, and whoever asked passes over the frames in between.
void Replay::GoTo(Time at) {
  const auto& chunks = log_.chunks();
  chunk_ = 0;
  while (chunk_ + 1 < chunks.size() && chunks[chunk_ + 1].head.first <= at) ++chunk_;
  at_ = frame_ = 0;
  goes_on_ = false;
}

bool Replay::Next() {
  if (!Read()) return false;
  Make();
  return true;
}

// A chunk that cannot be read is named and passed over; the next one begins with a state of its own.
bool Replay::Read() {
  while (chunk_ < log_.chunks().size()) {
    const Chunk& chunk = log_.chunks()[chunk_];
    if (frame_ == chunk.head.frames) {
      ++chunk_;
      at_ = frame_ = 0;
      continue;
    }
    if (frame_ == 0) BeginChunk();
    if (const auto fault = ReadFrame()) {
      faults_.push_back(fmt::format("the part of {} at byte {} is not played: {}",
                                    log_.DayTimeText(chunk.head.first), chunk.at_byte, *fault));
      ++chunk_;
      at_ = frame_ = 0;
      goes_on_ = false;
      continue;
    }
    return true;
  }
  return false;
}

// A state that goes on is kept although the chunk has its own: only so a whole evening is one play.
void Replay::BeginChunk() {
  const Chunk& chunk = log_.chunks()[chunk_];
  const bool next = chunk_ > 0 && log_.chunks()[chunk_ - 1].head.number + 1 == chunk.head.number;
  goes_on_ = goes_on_ && next && (chunk.head.flags & kContinues) != 0;
  words_ = {};
  times_ = {};
}

// A frame: flags, what has changed on the board since the frame before, a state where the flags say so, and
// the sum of what was made of it. Gives what is wrong with it, or nothing.
std::optional<std::string> Replay::ReadFrame() {
  const auto bytes = log_.chunks()[chunk_].frames.subspan(at_);
  if (bytes.empty() || bytes[0] > (kWithState | kEventsOfBoard)) return "it ends before its last frame";
  std::size_t at = 1;
  const auto changed = ReadChange(bytes.subspan(at), words_);
  if (!changed) return "its words cannot be read";
  at += *changed;
  if (!UnpackFrame(words_, times_, input_)) return "its words are no board";
  if ((bytes[0] & kEventsOfBoard) != 0) {
    if (frame_ == 0) return "it begins without its events";
    input_.seen = seen_;
    input_.events = performance::ReadEvents(input_.seen, input_.board);
  }
  seen_ = input_.seen;
  follows_ = goes_on_;
  if ((bytes[0] & kWithState) != 0)
    if (auto fault = ReadState(bytes, at)) return fault;
  if (!goes_on_) return "it begins without a state";
  if (bytes.size() < at + 2) return "it ends before its last frame";
  sum_ = wire::GetU16(bytes, at);
  at_ += at + 2;
  ++frame_;
  return std::nullopt;
}

// The state of a chunk's first frame is used where nothing goes on; that of a later frame always, since an
// editor made it.
std::optional<std::string> Replay::ReadState(std::span<const std::uint8_t> from, std::size_t& at) {
  state_words_ = {};
  const auto bytes = ReadChange(from.subspan(at), state_words_);
  if (!bytes) return "its state cannot be read";
  at += *bytes;
  if (frame_ == 0 && goes_on_) return std::nullopt;
  const performance::State state = UnpackState(state_words_);
  if (!performance::IsValid(state, show_))
    return "its state is of another show, or of a box with expressions of its own";
  made_.state = state;
  goes_on_ = true;
  return std::nullopt;
}

// The same function that the stage calls. Where its result has another sum, the frame is counted, and played
// all the same.
void Replay::Make() {
  made_.state.seen = input_.seen;
  made_ = performance::Animate(made_.state, input_.board, input_.events, show_, input_.presented_at);
  ++frames_;
  same_ = OutputSum(made_) == sum_;
  if (same_) return;
  ++differ_;
  if (!first_difference_) first_difference_ = input_.presented_at;
}

}  // namespace kaori::showlog
