// Everything that the stage needs of the board, read at one moment.
#pragma once

#include <array>

#include "appliance/core/board/board.h"

namespace kaori::board {

// A plain copy of about 7 KB, trivially copyable, so that it may be kept, compared and logged; a field that nobody writes
// has its default value and kAbsent. It does not change when the board does.
struct Snapshot {
  Stamped<Surface> surface;
  std::array<Stamped<Stick>, 2> sticks;  // [0] left (head), [1] right (gaze and brows).
  Stamped<Keys> keys;
  Stamped<Lines> lines;
  std::array<Stamped<Calls>, kCallWriters> calls;  // By CallWriter.
  Stamped<Pointer> pointer;
  Stamped<Lips> lips;
  Stamped<Voice> voice;
  Stamped<LipsGuide> lips_guide;
  Stamped<Desk> desk;
  Stamped<Lamps> lamps;
  Stamped<StageStatus> stage_status;
  Stamped<LineCheck> line_check;
};

// Each section is whole and valid in itself; two sections may be a few hundred nanoseconds apart. Never
// waits. `performance` is not among them: its owner reads it once, at its start.
Snapshot ReadAll(const Board& board);

// Snapshots that do not blink while the board is replaced beneath their reader. One thread; the board must
// outlive it.
class SnapshotReader {
 public:
  // Borrows the board. Until the first Read nothing has been read.
  explicit SnapshotReader(const Board& board) : board_(board), moves_(board.moves()) {}

  // As ReadAll. While the board is spoilt everything stays as it was; for a second after it was replaced so
  // does each section that nobody has written on the new one, until its writer has moved there too. After
  // that an absent section has no writer. What it gives holds until the next call.
  const Snapshot& Read(Time now);

  // True in that second: counters of the new board are no difference to those of the one before.
  bool settling() const { return settling_; }

 private:
  const Board& board_;
  Snapshot last_;
  std::uint32_t moves_;
  bool settling_ = false;
  Time settled_at_{};
};

}  // namespace kaori::board
