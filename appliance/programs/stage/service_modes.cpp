#include "appliance/programs/stage/service_modes.h"

#include "appliance/core/board/keys.h"
#include "appliance/core/board/lines.h"
#include "appliance/programs/stage/withheld.h"

namespace kaori::stage {
namespace {

// Whether kaori-shows runs: one that was killed is silent, and nothing that it left on the board counts. It
// ends with the service key, and a little later.
bool HasMenu(const board::Stamped<board::ShowsMenu>& menu, const LineChecker::Frame& frame) {
  return menu.source == board::SourceState::kLive && frame.now - menu.at < board::kMenuSilence &&
         board::IsServiceKeyOn(frame.live.lines);
}

}  // namespace

const board::Snapshot& ServiceModes::Step(const LineChecker::Frame& frame, performance::InputEvents& events) {
  const auto menu = frame.board.Read<board::ShowsMenu>();
  if (HasMenu(menu, frame) && !checker_.running() && !learner_.running()) {
    if (menu.value.open != 0) return WithholdForMenu(frame, events);
    events.Consume(
        [](const performance::Press& press) { return press.IsKey() && press.code == board::key::kPageUp; });
  }
  if (!learner_.running()) {
    const board::Snapshot& left = checker_.Step(frame, events);
    if (checker_.running() || &left != &frame.snapshot) return left;
  }
  return learner_.Step({frame.live, frame.snapshot, frame.show, frame.now}, events);
}

// Lines stay: a blackout is black even now.
const board::Snapshot& ServiceModes::WithholdForMenu(const LineChecker::Frame& frame,
                                                     performance::InputEvents& events) {
  ConsumeAllBut(
      events, [&](const performance::Press& press) { return IsHeardAlways(press, frame.state, frame.show); });
  left_ = frame.snapshot;
  Release(left_);
  return left_;
}

}  // namespace kaori::stage
