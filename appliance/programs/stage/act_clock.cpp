#include "appliance/programs/stage/act_clock.h"

#include <algorithm>

namespace kaori::stage {

std::int32_t ActOpener(const show::CueList& list, std::int32_t cue) {
  cue = std::min(cue, static_cast<std::int32_t>(list.cues.size()) - 1);
  while (cue > 0 && list.cues[static_cast<std::size_t>(cue)].act.empty()) --cue;
  return cue;
}

ActClock::ActClock(const board::Stamped<board::ShowNow>& before, const show::CueList& list,
                   std::int32_t active)
    : active_(active), opener_(ActOpener(list, active)) {
  const bool is_known =
      before.source == board::SourceState::kLive && before.value.cue_active == active && active >= 0;
  if (is_known) began_ = before.value.act_began;
}

// Two cues in a row may name the same act.
Time ActClock::Step(const show::CueList& list, std::int32_t active, Time now) {
  if (active == active_) return began_;
  active_ = active;
  const std::int32_t opener = ActOpener(list, active);
  const auto is_same = [&] {
    return opener >= 0 && opener_ >= 0 &&
           list.cues[static_cast<std::size_t>(opener)].act ==
               list.cues[static_cast<std::size_t>(opener_)].act;
  };
  if (!is_same()) began_ = active < 0 ? Time{} : now;
  opener_ = opener;
  return began_;
}

}  // namespace kaori::stage
