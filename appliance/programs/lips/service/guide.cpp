#include "appliance/programs/lips/service/guide.h"

#include <numeric>
#include <utility>

#include "appliance/core/board/keys.h"
#include "appliance/core/board/mouth.h"
#include "drivers/base/log.h"

namespace kaori::lips {
namespace {

namespace key = board::key;

// How long the key is held: nobody leans on F12 for two seconds in a show. And after how long without a push
// somebody has gone away.
constexpr Duration kHold = std::chrono::seconds(2);
constexpr Duration kIdleLimit = std::chrono::seconds(60);
constexpr std::uint32_t kSaveStep = 4;  // The step after the four poses.
constexpr float kCleanMouth = 0.8F;     // The quality from which on the paint need not be sampled first.

}  // namespace

// The sums may wrap, since only differences count. Every button of the box confirms, since an operator with
// painted lips does not look for one of them.
Guide::Pushes Guide::PushesOf(const board::Keys& keys, const board::Surface& surface) {
  return {keys.pushes[key::kEnter] + keys.pushes[key::kPadEnter] +
              std::accumulate(surface.pushes.begin(), surface.pushes.end(), 0U),
          keys.pushes[key::kEscape]};
}

// The key has to be let go before it can begin another calibration.
void Guide::Step(const board::Stamped<board::Keys>& keys, const board::Stamped<board::Surface>& surface,
                 const board::Lips& lips, Tuning& tuning, Time now) {
  // A section that is absent says nothing: while the board is replaced nobody has pushed anything.
  const bool published =
      keys.source != board::SourceState::kAbsent || surface.source != board::SourceState::kAbsent;
  const Pushes pushes = published ? PushesOf(keys.value, surface.value) : seen_pushes_;
  const Pushes before = std::exchange(seen_pushes_, pushes);
  const bool down = keys.source == board::SourceState::kLive &&
                    (IsDown(keys.value, key::kF12) || IsDown(keys.value, key::kInsert));
  if (!down) held_since_.reset();
  if (!down) released_ = true;
  if (down && !held_since_) held_since_ = now;
  seen_ = board::IsLearnable(lips);
  if (!active_) {
    if (down && released_ && now - *held_since_ >= kHold) Start(lips, tuning, now);
    return;
  }
  FollowStep(tuning, now);
  if (pushes.cancels != before.cancels || now - idle_since_ >= kIdleLimit) return Abandon(tuning);
  if (pushes.confirms != before.confirms && !measurement_) BeginPose(tuning, now);
}

// The number of changes is noted, which is what Escape goes back to, whatever a desk has changed before.
void Guide::Start(const board::Lips& lips, Tuning& tuning, Time now) {
  Log("lips: a calibration by keyboard begins");
  active_ = true;
  released_ = false;
  step_ = 0;
  measurement_ = false;
  progress_ = 0;
  before_ = tuning.report().changes;
  idle_since_ = now;
  tuning.Execute({.kind = CommandKind::kStop}, now);
  tuning.Execute({.kind = CommandKind::kExposure, .a = 1}, now);
  if (lips.quality < kCleanMouth) tuning.Execute({.kind = CommandKind::kFind}, now);
}

// A step that is done changed the settings. One that a desk cancelled did not, and its pose is asked for
// again.
void Guide::FollowStep(Tuning& tuning, Time now) {
  const Report& report = tuning.report();
  progress_ = report.progress;
  if (!measurement_ || report.step) return;
  measurement_ = false;
  progress_ = 0;
  idle_since_ = now;
  if (report.changes != before_step_) ++step_;
}

// The exposure is held from the first pose on: sizes that are measured under changing exposure differ.
void Guide::BeginPose(Tuning& tuning, Time now) {
  idle_since_ = now;
  if (step_ == kSaveStep) {
    tuning.Execute({.kind = CommandKind::kSave}, now);
    active_ = false;
    return;
  }
  if (step_ == 0) tuning.Execute({.kind = CommandKind::kExposure, .a = 0}, now);
  before_step_ = tuning.report().changes;
  measurement_ = true;
  tuning.Execute(
      {.kind = CommandKind::kBegin, .name = std::string(NameOf(static_cast<CalibrationStep>(step_)))}, now);
}

// Undone rather than overwritten, so that changes which a desk made before the calibration stay.
void Guide::Abandon(Tuning& tuning) {
  Log("lips: the calibration by keyboard was cancelled; the settings are as before");
  tuning.RevertTo(before_);
  tuning.Execute({.kind = CommandKind::kExposure, .a = 0}, idle_since_);
  active_ = false;
}

// For the stage, which shows it on the screen and by the lamps (stage/service_display.cpp).
board::LipsGuide Guide::state(bool captions) const {
  return {.step = step_,
          .taking = measurement_ ? 1U : 0U,
          .progress = progress_,
          .seen = seen_ ? 1U : 0U,
          .captions = captions ? 1U : 0U};
}

}  // namespace kaori::lips
