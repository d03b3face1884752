// What one frame was made of, besides the show and the state before it, as words.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"

namespace kaori::showlog {

// All that performance::Animate was given of the board, and the line check for the report. Other sections
// that it does not read (lamps, guide, desk, status) are absent: a log says nothing of pairing codes.
struct FrameInput {
  Time presented_at{};
  board::Snapshot board;
  performance::SeenInput seen;  // Of the state that Animate was given.
  performance::InputEvents events;
};

// Calls `with` for each section of a board::Snapshot that is in the log, in the order of its words.
template <class Board, class With>
constexpr void ForSections(Board& board, With with) {
  with(board.surface);
  for (auto& stick : board.sticks) with(stick);
  with(board.keys);
  with(board.lines);
  for (auto& calls : board.calls) with(calls);
  with(board.pointer);
  with(board.lips);
  with(board.voice);
  with(board.line_check);
}

// The times of the frame before, from which those of the next one are told. A chunk begins with none.
struct FrameTimes {
  static constexpr std::size_t kSections = 11;
  Time presented_at{};
  std::array<Time, kSections> stamps{};
};

namespace internal {
template <class T>
inline constexpr std::size_t kWordsOf = sizeof(T) / sizeof(std::uint32_t);
inline constexpr std::size_t kSectionHead = 3;  // The age in two words, and the state of the source.
template <class... Sections>
inline constexpr std::size_t kWordsOfSections = (0 + ... + (kSectionHead + kWordsOf<Sections>));
}  // namespace internal

// The time since the frame before; a bit for each section whose stamp is another one than before; the
// sections, of which each has its age instead of its stamp, since that hardly changes; what was seen, the
// events. Values are as they lie in memory of this build (WordsLayout tells builds apart).
inline constexpr std::size_t kFrameWords =
    internal::kWordsOf<Duration> + 1 +
    internal::kWordsOfSections<board::Surface, board::Stick, board::Stick, board::Keys, board::Lines,
                               board::Calls, board::Calls, board::Pointer, board::Lips, board::Voice,
                               board::LineCheck> +
    internal::kWordsOf<performance::SeenInput> + internal::kWordsOf<performance::InputEvents>;
using FrameWords = std::array<std::uint32_t, kFrameWords>;

inline constexpr std::size_t kStateWords = internal::kWordsOf<performance::State>;
using StateWords = std::array<std::uint32_t, kStateWords>;
static_assert(std::is_trivially_copyable_v<performance::InputEvents> &&
              sizeof(performance::InputEvents) % sizeof(std::uint32_t) == 0 &&
              sizeof(performance::State) % sizeof(std::uint32_t) == 0);

// Tells one build's words from another's: names and sizes of the board's sections, and the layout of the
// state.
std::uint64_t WordsLayout();

// Both allocate nothing. `into` holds the words of the frame before, and `times` its times: both become those
// of this one. What was seen and the events are none of it; PackEvents adds them.
void PackFrame(Time presented_at, const board::Snapshot& board, FrameTimes& times, FrameWords& into);
void PackEvents(const performance::SeenInput& seen, const performance::InputEvents& events, FrameWords& into);
void PackState(const performance::State& state, StateWords& into);

// True where both say the same. A frame whose events are those that the board gives (performance::ReadEvents)
// needs no word for them.
bool IsSame(const performance::InputEvents& a, const performance::InputEvents& b);

// False where the words are no frame that a stage can have played: a section that is not valid, more events
// than there can be. `times` are those of the frame before, and become those of this one.
bool UnpackFrame(const FrameWords& words, FrameTimes& times, FrameInput& into);
// Any words; the caller asks performance::IsValid.
performance::State UnpackState(const StateWords& words);

}  // namespace kaori::showlog
