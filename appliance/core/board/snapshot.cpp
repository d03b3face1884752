#include "appliance/core/board/snapshot.h"

#include <chrono>
#include <utility>

namespace kaori::board {
namespace {

// Four periods of Board::Heal: by then each program that runs has looked, and has moved its sections.
constexpr Duration kSettling = std::chrono::seconds(1);

// A section that is absent on the new board is one whose writer has not moved yet; its last value stands in.
template <class T>
void KeepAbsent(Stamped<T>& now, const Stamped<T>& before) {
  if (now.source == SourceState::kAbsent) now = before;
}

// Section by section: each writer moves in its own time.
void KeepAbsent(Snapshot& now, const Snapshot& before) {
  KeepAbsent(now.surface, before.surface);
  for (std::size_t i = 0; i < now.sticks.size(); ++i) KeepAbsent(now.sticks[i], before.sticks[i]);
  KeepAbsent(now.keys, before.keys);
  KeepAbsent(now.lines, before.lines);
  for (std::size_t i = 0; i < now.calls.size(); ++i) KeepAbsent(now.calls[i], before.calls[i]);
  KeepAbsent(now.pointer, before.pointer);
  KeepAbsent(now.lips, before.lips);
  KeepAbsent(now.voice, before.voice);
  KeepAbsent(now.lips_guide, before.lips_guide);
  KeepAbsent(now.desk, before.desk);
  KeepAbsent(now.lamps, before.lamps);
  KeepAbsent(now.stage_status, before.stage_status);
  KeepAbsent(now.line_check, before.line_check);
}

}  // namespace

// `sound`, `motion_now`, `show_now` and `learn` are not here: the stage's frames do not depend on them. Nor
// is `shows_menu`, which decides of events alone.
Snapshot ReadAll(const Board& board) {
  return {.surface = board.Read<Surface>(),
          .sticks = {board.Read<Stick>(0), board.Read<Stick>(1)},
          .keys = board.Read<Keys>(),
          .lines = board.Read<Lines>(),
          .calls = {board.Read<Calls>(0), board.Read<Calls>(1)},
          .pointer = board.Read<Pointer>(),
          .lips = board.Read<Lips>(),
          .voice = board.Read<Voice>(),
          .lips_guide = board.Read<LipsGuide>(),
          .desk = board.Read<Desk>(),
          .lamps = board.Read<Lamps>(),
          .stage_status = board.Read<StageStatus>(),
          .line_check = board.Read<LineCheck>()};
}

// The check comes after the reading: pages may vanish in the middle of it.
const Snapshot& SnapshotReader::Read(Time now) {
  Snapshot read = ReadAll(board_);
  if (!board_.intact()) return last_;
  if (std::exchange(moves_, board_.moves()) != board_.moves()) settled_at_ = now + kSettling;
  settling_ = now < settled_at_;
  if (settling_) KeepAbsent(read, last_);
  last_ = read;
  return last_;
}

}  // namespace kaori::board
