#include "appliance/core/performance/input_events.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "appliance/core/show/call.h"

namespace kaori::performance {
namespace {

using board::PressLog;

constexpr std::uint32_t kShifts = (1U << 1U | 1U << 5U) << 8U;  // E1 and E5 among the modifiers of a press.

// Counters wrap after years, and their difference is right all the same.
std::int32_t Difference(std::int32_t now, std::int32_t before) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(now) - static_cast<std::uint32_t>(before));
}

// The presses of a log since `seen`, oldest first.
class LogReader {
 public:
  LogReader(const PressLog& log, std::uint32_t seen)
      : log_(log), next_(log.count - std::min<std::uint32_t>(log.count - seen, PressLog::kKept)) {}

  bool empty() const { return next_ == log_.count; }
  const PressLog::Press& front() const { return log_.newest[next_ % PressLog::kKept]; }
  const PressLog::Press& Next() { return log_.newest[next_++ % PressLog::kKept]; }

 private:
  const PressLog& log_;
  std::uint32_t next_;
};

// The times of two presses are 32 bits of microseconds and wrap. The sign of their difference orders any two
// that are less than 35 minutes apart, and unread presses are a frame apart.
bool IsEarlier(const PressLog::Press& one, const PressLog::Press& other) {
  return static_cast<std::int32_t>(one.at_us - other.at_us) < 0;
}

// A stale section is there: its counters stay when a device is unplugged, and count on when it is back.
template <class T>
bool IsThere(const board::Stamped<T>& section) {
  return section.source != board::SourceState::kAbsent;
}

// Where a section is seen for the first time on another board, nothing has happened since. Calls are told by
// their times instead (FreshCalls).
void Adopt(SeenInput& seen, const board::Snapshot& board) {
  if (IsThere(board.surface) && std::exchange(seen.surface_unknown, 0) != 0) {
    seen.dials = board.surface.value.counts;
    seen.button_presses = board.surface.value.log.count;
  }
  if (IsThere(board.keys) && std::exchange(seen.keys_unknown, 0) != 0)
    seen.key_presses = board.keys.value.log.count;
  for (std::size_t i = 0; i < board.sticks.size(); ++i)
    if (IsThere(board.sticks[i]) && std::exchange(seen.sticks_unknown[i], 0) != 0)
      seen.stick_presses[i] = board.sticks[i].value.log.count;
  if (IsThere(board.pointer) && std::exchange(seen.pointer_unknown, 0) != 0)
    seen.pointer = board.pointer.value;
}

const board::Call& CallBefore(const board::Calls& log, std::uint32_t count) {
  return log.newest[(count - 1) % board::Calls::kKept];
}

// How many calls at the log's end nobody was told of. On another board a writer may have begun to count anew,
// and its calls are known by their times: those of one writer are in order.
std::uint32_t FreshCalls(const board::Calls& log, const SeenInput& seen, std::size_t writer) {
  if ((seen.calls_unknown & 1U << writer) == 0) return log.count - seen.calls[writer];
  const std::uint32_t kept = std::min<std::uint32_t>(log.count, board::Calls::kKept);
  std::uint32_t fresh = 0;
  while (fresh < kept && CallBefore(log, log.count - fresh).at > seen.called_at[writer]) ++fresh;
  return fresh;
}

void NoteSeen(const board::Calls& log, SeenInput& seen, std::size_t writer) {
  seen.calls[writer] = log.count;
  seen.calls_unknown = static_cast<std::uint8_t>(seen.calls_unknown & ~(1U << writer));
  if (log.count != 0) seen.called_at[writer] = CallBefore(log, log.count).at;
}

// Merges what lies in [middle, end) into the calls before it, without the memory that std::inplace_merge
// takes. Equal times keep the order of the writers.
void MergeByTime(board::Call* begin, board::Call* middle, board::Call* end) {
  for (; middle != end; ++middle)
    for (board::Call* at = middle; at != begin && at->at < (at - 1)->at; --at) std::swap(*at, *(at - 1));
}

// A press is placed where the pointer is now, at most one frame of movement away from where it happened.
InputEvents::Pointer PointerEvents(const board::Pointer& before, const board::Pointer& now) {
  InputEvents::Pointer events{.moved = {now.x - before.x, now.y - before.y},
                              .notches = Difference(now.wheel, before.wheel)};
  if (now.pushes[0] != before.pushes[0]) events.pressed = glm::vec2(now.x, now.y);
  return events;
}

}  // namespace

// Buttons and keys are merged by the time of each. Two keys typed within one frame thus keep their order, and
// so do a key and a button of different devices. On equal times the dial box comes first, which is of no
// account.
void InputEvents::AddPresses(SeenInput& seen, const board::Snapshot& board) {
  const PressLog& button_log = board.surface.value.log;
  const PressLog& key_log = board.keys.value.log;
  const PressLog &left_log = board.sticks[0].value.log, &right_log = board.sticks[1].value.log;
  constexpr std::uint32_t kLeft = show::kButtonCount, kRight = kLeft + show::kStickButtonCount;
  std::array<LogReader, 4> readers{
      LogReader(button_log, IsThere(board.surface) ? seen.button_presses : button_log.count),
      LogReader(key_log, IsThere(board.keys) ? seen.key_presses : key_log.count),
      LogReader(left_log, IsThere(board.sticks[0]) ? seen.stick_presses[0] : left_log.count),
      LogReader(right_log, IsThere(board.sticks[1]) ? seen.stick_presses[1] : right_log.count)};
  constexpr std::array<std::uint32_t, 4> kFirstCodes{0, 0, kLeft, kRight};
  while (true) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < readers.size(); ++i)
      if (!readers[i].empty() && (!first || IsEarlier(readers[i].front(), readers[*first].front())))
        first = i;
    if (!first) break;
    const PressLog::Press& press = readers[*first].Next();
    presses_[count_++] = {*first == 1 ? Press::Source::kKey : Press::Source::kButton,
                          static_cast<std::uint8_t>((press.code & 0xFFU) + kFirstCodes[*first]),
                          (press.code & kShifts) != 0, press.at_us};
  }
  if (IsThere(board.surface)) seen.button_presses = button_log.count;
  if (IsThere(board.sticks[0])) seen.stick_presses[0] = left_log.count;
  if (IsThere(board.sticks[1])) seen.stick_presses[1] = right_log.count;
  if (IsThere(board.keys)) seen.key_presses = key_log.count;
}

// The log of each writer is in order, but two writers may have called in turns: they are merged by the times
// of the calls. Of more calls than a log keeps the oldest are lost, and counted.
void InputEvents::AddCalls(SeenInput& seen, const board::Snapshot& board) {
  for (std::size_t i = 0; i < board.calls.size(); ++i) {
    if (!IsThere(board.calls[i])) continue;
    const board::Calls& log = board.calls[i].value;
    const std::uint32_t fresh = FreshCalls(log, seen, i);
    NoteSeen(log, seen, i);
    const std::uint32_t kept = std::min<std::uint32_t>(fresh, board::Calls::kKept);
    lost_calls_ += fresh - kept;
    const auto begin = calls_.begin() + static_cast<std::ptrdiff_t>(call_count_);
    for (std::uint32_t n = log.count - kept; n != log.count; ++n)
      calls_[call_count_++] = log.newest[n % board::Calls::kKept];
    const auto end = calls_.begin() + static_cast<std::ptrdiff_t>(call_count_);
    MergeByTime(calls_.begin(), begin, end);
  }
}

SeenInput SeenOn(const board::Snapshot& board) {
  SeenInput seen{.dials = board.surface.value.counts,
                 .button_presses = board.surface.value.log.count,
                 .key_presses = board.keys.value.log.count,
                 .stick_presses = {board.sticks[0].value.log.count, board.sticks[1].value.log.count},
                 .pointer = board.pointer.value};
  for (std::size_t i = 0; i < board.calls.size(); ++i) NoteSeen(board.calls[i].value, seen, i);
  return seen;
}

// Adoption comes first: where a section is of another board its counters are taken over,
// and no difference is left.
InputEvents ReadEvents(SeenInput& seen, const board::Snapshot& board) {
  Adopt(seen, board);
  InputEvents events;
  events.AddPresses(seen, board);
  events.AddCalls(seen, board);
  if (IsThere(board.surface)) {
    const auto before = std::exchange(seen.dials, board.surface.value.counts);
    std::ranges::transform(seen.dials, before, events.turned.begin(), Difference);
  }
  if (IsThere(board.pointer))
    events.pointer = PointerEvents(std::exchange(seen.pointer, board.pointer.value), board.pointer.value);
  return events;
}

void ForgetCounters(SeenInput& seen) {
  seen.surface_unknown = seen.keys_unknown = seen.pointer_unknown = 1;
  seen.sticks_unknown = {1, 1};
  seen.calls_unknown = (1U << board::kCallWriters) - 1;
}

}  // namespace kaori::performance
