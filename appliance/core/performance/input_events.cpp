#include "appliance/core/performance/input_events.h"

#include <algorithm>
#include <utility>

#include "appliance/core/board/lines.h"

namespace kaori::performance {
namespace {

using board::PressLog;

constexpr std::uint32_t kShifts = (1U << 1U | 1U << 5U) << 8U;  // E1 and E5 among the modifiers of a press.
constexpr auto kGoLine = static_cast<std::size_t>(board::Line::kGo);

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

// Where a section is seen for the first time on another board, nothing has happened since.
void Adopt(SeenInput& seen, const board::Snapshot& board) {
  if (IsThere(board.surface) && std::exchange(seen.surface_unknown, 0) != 0) {
    seen.dials = board.surface.value.counts;
    seen.button_presses = board.surface.value.log.count;
  }
  if (IsThere(board.keys) && std::exchange(seen.keys_unknown, 0) != 0)
    seen.key_presses = board.keys.value.log.count;
  if (IsThere(board.lines) && std::exchange(seen.lines_unknown, 0) != 0)
    seen.gos = board.lines.value.pushes[kGoLine];
  if (IsThere(board.pointer) && std::exchange(seen.pointer_unknown, 0) != 0)
    seen.pointer = board.pointer.value;
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
// so do a key and a button of different devices. On equal times the button comes first, which is of no account.
void InputEvents::AddPresses(SeenInput& seen, const board::Snapshot& board) {
  const PressLog& button_log = board.surface.value.log;
  const PressLog& key_log = board.keys.value.log;
  LogReader buttons(button_log, IsThere(board.surface) ? seen.button_presses : button_log.count);
  LogReader keys(key_log, IsThere(board.keys) ? seen.key_presses : key_log.count);
  while (!buttons.empty() || !keys.empty()) {
    const bool key = buttons.empty() || (!keys.empty() && IsEarlier(keys.front(), buttons.front()));
    const std::uint32_t code = key ? keys.Next().code : buttons.Next().code;
    presses_[count_++] = {key ? Press::Source::kKey : Press::Source::kButton,
                          static_cast<std::uint8_t>(code & 0xFFU), (code & kShifts) != 0};
  }
  if (IsThere(board.surface)) seen.button_presses = button_log.count;
  if (IsThere(board.keys)) seen.key_presses = key_log.count;
}

SeenInput SeenOn(const board::Snapshot& board) {
  return {.dials = board.surface.value.counts,
          .button_presses = board.surface.value.log.count,
          .key_presses = board.keys.value.log.count,
          .gos = board.lines.value.pushes[kGoLine],
          .pointer = board.pointer.value};
}

InputEvents ReadEvents(SeenInput& seen, const board::Snapshot& board) {
  Adopt(seen, board);
  InputEvents events;
  events.AddPresses(seen, board);
  if (IsThere(board.surface)) {
    const auto before = std::exchange(seen.dials, board.surface.value.counts);
    std::ranges::transform(seen.dials, before, events.turned.begin(), Difference);
  }
  if (IsThere(board.lines)) {
    const std::uint32_t gos = board.lines.value.pushes[kGoLine];
    events.go = std::exchange(seen.gos, gos) != gos;
  }
  if (IsThere(board.pointer))
    events.pointer = PointerEvents(std::exchange(seen.pointer, board.pointer.value), board.pointer.value);
  return events;
}

void ForgetCounters(SeenInput& seen) {
  seen.surface_unknown = seen.keys_unknown = seen.lines_unknown = seen.pointer_unknown = 1;
}

}  // namespace kaori::performance
