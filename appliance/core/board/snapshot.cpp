#include "appliance/core/board/snapshot.h"

namespace kaori::board {

Snapshot ReadAll(const Board& board) {
  return {.surface = board.Read<Surface>(),
          .sticks = {board.Read<Stick>(0), board.Read<Stick>(1)},
          .keys = board.Read<Keys>(),
          .lines = board.Read<Lines>(),
          .pointer = board.Read<Pointer>(),
          .lips = board.Read<Lips>(),
          .voice = board.Read<Voice>(),
          .lips_guide = board.Read<LipsGuide>(),
          .desk = board.Read<Desk>(),
          .lamps = board.Read<Lamps>(),
          .stage_status = board.Read<StageStatus>()};
}

}  // namespace kaori::board
