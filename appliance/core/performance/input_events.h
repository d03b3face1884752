// What the operators did between two looks at the board, in the order in which they did it.
//
// Events are made once a frame and handed from consumer to consumer: a calibration at the box, the expression
// editor, the performance. Whoever uses an event takes it out, so that nothing that an operator does is used
// twice.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "appliance/core/board/snapshot.h"

namespace kaori::performance {

// A button of the control surface or of a stick, or a key, that went down.
struct Press {
  enum class Source : std::uint8_t { kButton, kKey } source = Source::kButton;
  std::uint8_t code = 0;    // The button's number (show::kAllButtonCount), or the key's usage of HID page 7.
  bool shift = false;       // Of a key: a Shift key was held with it.
  std::uint32_t at_us = 0;  // As PressLog::Press has it.

  bool IsKey() const { return source == Source::kKey; }
};

// The board's counters as they stood at the last frame; events are the differences. Plain bytes, kept with
// the performance's state over a restart of the stage.
struct SeenInput {
  std::array<std::int32_t, 8> dials{};
  std::uint32_t button_presses = 0;
  std::uint32_t key_presses = 0;
  std::array<std::uint32_t, 2> stick_presses{};
  std::array<std::uint32_t, board::kCallWriters> calls{};
  board::Pointer pointer;
  // 1: the counters above are of another board. What the section shows next is taken as seen; of
  // calls_unknown, a bit for each writer, what is newer than `called_at`.
  std::uint8_t surface_unknown = 0, keys_unknown = 0, calls_unknown = 0, pointer_unknown = 0;
  std::array<std::uint8_t, 2> sticks_unknown{};
  // When the newest call of each writer was made that was told of. Counters begin anew on another board, and
  // times do not.
  std::array<Time, board::kCallWriters> called_at{};
};

// The events of one frame. A plain value without memory of its own; one thread.
class InputEvents {
 public:
  // All logs whole, of dial box, keyboard and both sticks: more presses than they keep cannot be told of.
  static constexpr std::size_t kMostPresses = 4 * board::PressLog::kKept;

  // All logs of calls whole.
  static constexpr std::size_t kMostCalls = board::kCallWriters * board::Calls::kKept;

  // In the order of time. Of more than PressLog::kKept presses of one section the newest are here.
  std::span<const Press> presses() const { return std::span(presses_).first(count_); }

  // What was called on the board, of all writers, in the order of time.
  std::span<const board::Call> calls() const { return std::span(calls_).first(call_count_); }
  // How many calls are lost because more of one writer came within a frame than its log keeps.
  std::uint32_t lost_calls() const { return lost_calls_; }

  // Takes out every press for which `consumes(press)` holds; it is called once for each, in the order of
  // time.
  template <class Predicate>
  void Consume(Predicate consumes) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i)
      if (const Press press = presses_[i]; !consumes(press)) presses_[kept++] = press;
    count_ = kept;
  }

  // The same of calls.
  template <class Predicate>
  void ConsumeCalls(Predicate consumes) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < call_count_; ++i)
      if (const board::Call call = calls_[i]; !consumes(call)) calls_[kept++] = call;
    call_count_ = kept;
  }

  // Counts of each dial since the last frame; clockwise is positive. How many make a turn is
  // Surface::counts_per_turn. A consumer sets what it uses to 0.
  std::array<std::int32_t, 8> turned{};
  struct Pointer {
    std::optional<glm::vec2> pressed{};  // Where the left button went down, 0..1 from the left top.
    glm::vec2 moved{};                   // Right and down, in parts of the picture.
    std::int32_t notches = 0;            // Of the wheel; away from the hand is positive.
  } pointer;
  // Minutes since Monday 00:00 in local time, below 10 080; -1: the wall clock cannot be believed. No value:
  // it has not changed. Whoever knows the time says it; the board does not.
  std::optional<std::int32_t> week_minute{};

 private:
  friend InputEvents ReadEvents(SeenInput& seen, const board::Snapshot& board);
  void AddPresses(SeenInput& seen, const board::Snapshot& board);
  void AddCalls(SeenInput& seen, const board::Snapshot& board);

  std::array<Press, kMostPresses> presses_{};
  std::size_t count_ = 0;
  std::array<board::Call, kMostCalls> calls_{};
  std::size_t call_count_ = 0;
  std::uint32_t lost_calls_ = 0;
};

// The board's counters as they stand: nothing before them is an event. For a stage that starts: what was
// pressed before it did is over.
SeenInput SeenOn(const board::Snapshot& board);

// What happened since `seen`, which is brought up to the board. A section that is absent says nothing: its
// counters are nobody's. Pure, and allocates nothing. Calling it twice with one snapshot gives the events
// once. Where a log has lost presses because more than PressLog::kKept happened since the last call, the
// newest kKept of that log are given.
InputEvents ReadEvents(SeenInput& seen, const board::Snapshot& board);

// The board is another one than that of `seen`: its counters are taken as they are found. To be called while
// SnapshotReader::settling(): each section's counters are adopted when it is seen first, so that presses on
// the way from one board to the other are lost rather than invented. Calls have whole times: each is told of
// once, whenever its writer comes to the new board.
void ForgetCounters(SeenInput& seen);

}  // namespace kaori::performance
