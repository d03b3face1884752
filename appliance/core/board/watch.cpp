#include "appliance/core/board/watch.h"

#include <string>
#include <utility>

#include "drivers/base/log.h"

namespace kaori::board {

// `trouble` is the reason that was logged last. A Heal that works clears it, so that the same reason is
// logged again when it comes back later.
Result<void> Watch(Board& board, EventLoop& loop) {
  return loop.Every(Board::kHealPeriod, [&board, trouble = std::string()]() mutable {
    const auto healed = board.Heal();
    const std::string now = healed ? std::string() : healed.error().message();
    if (healed && *healed)
      LogWarning("board {} was lost; playing on with the one that is there now", board.path());
    if (!now.empty() && now != trouble) LogWarning("{}; it is tried again", now);
    trouble = now;
  });
}

}  // namespace kaori::board
