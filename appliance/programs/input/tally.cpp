#include "appliance/programs/input/tally.h"

#include "appliance/core/board/lines.h"

namespace kaori::input {
namespace {

// A stage that draws slowly is not dead: its usual drawing time counts besides, so that a machine with a
// frame every two seconds keeps its lamp.
constexpr Duration kDead = std::chrono::seconds(1);
constexpr int kTurns = 4;

}  // namespace

// By the stamp and not by the state: a stage that was killed leaves its section live.
bool TallyLit(const board::Stamped<board::StageStatus>& stage, const board::Stamped<board::Lines>& lines,
              Time now) {
  if (stage.source != board::SourceState::kLive) return false;
  if (now - stage.at > kDead + kTurns * stage.value.draw) return false;
  return !board::IsOn(lines.value, board::Line::kBlackout);
}

}  // namespace kaori::input
