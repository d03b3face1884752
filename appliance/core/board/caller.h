// Writes one program's calls on the board.
#pragma once

#include "appliance/core/board/board.h"

namespace kaori::board {

// Goes on from what its section holds, so that the calls before a restart stay. One thread, that of its
// board.
class Caller {
 public:
  // Acquires the section of `which` for as long as the caller lives, as Board::AcquireWriter does. What the section holds
  // is read once: the count goes on from there. Errors: as Board::AcquireWriter; a second writer of the same section is refused.
  static Result<Caller> Acquire(const Board& board, CallWriter which) {
    auto writer = board.AcquireWriter<Calls>(static_cast<int>(which));
    if (!writer) return tl::unexpected(writer.error());
    return Caller(std::move(*writer), board.Read<Calls>(static_cast<int>(which)).value);
  }

  // Puts the call on the board at once; never waits. `call.at` is when the person called.
  void Make(const Call& call) {
    Append(calls_, call);
    writer_.Write(calls_, call.at, SourceState::kLive);
  }

 private:
  Caller(Writer<Calls> writer, const Calls& before) : writer_(std::move(writer)), calls_(before) {}

  Writer<Calls> writer_;
  Calls calls_;
};

}  // namespace kaori::board
