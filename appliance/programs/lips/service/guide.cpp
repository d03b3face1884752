#include "appliance/programs/lips/service/guide.h"

#include <numeric>
#include <utility>

#include "drivers/base/log.h"

namespace kaori::lips {
namespace {

constexpr Duration kHold = std::chrono::seconds(2);
constexpr Duration kPatience = std::chrono::seconds(60);
constexpr std::uint32_t kKeep = 4;   // The step after the four poses.
constexpr float kCleanMouth = 0.8F;  // Its paint is known: it need not be looked for.
constexpr float kGoodMouth = 0.5F;   // What a calibration counts.
constexpr std::size_t kEnter = 0x28, kEscape = 0x29, kF12 = 0x45, kInsert = 0x49,
                      kPadEnter = 0x58;  // HID page 7.

bool IsDown(const board::Keys& keys, std::size_t usage) {
  return ((keys.down[usage / 32] >> (usage % 32)) & 1U) != 0;
}

}  // namespace

// Only differences count, so that they may wrap.
Guide::Pushes Guide::PushesOf(const board::Keys& keys, const board::Surface& surface) {
  return {keys.pushes[kEnter] + keys.pushes[kPadEnter] +
              std::accumulate(surface.pushes.begin(), surface.pushes.end(), 0U),
          keys.pushes[kEscape]};
}

void Guide::Step(const board::Stamped<board::Keys>& keys, const board::Stamped<board::Surface>& surface,
                 float quality, Tuning& tuning, Time now) {
  // A section that is absent says nothing: while the board is replaced nobody has pushed anything.
  const bool told =
      keys.source != board::SourceState::kAbsent || surface.source != board::SourceState::kAbsent;
  const Pushes pushes = told ? PushesOf(keys.value, surface.value) : seen_pushes_;
  const Pushes before = std::exchange(seen_pushes_, pushes);
  const bool down =
      keys.source == board::SourceState::kLive && (IsDown(keys.value, kF12) || IsDown(keys.value, kInsert));
  if (!down) held_since_.reset();
  if (!down) let_go_ = true;
  if (down && !held_since_) held_since_ = now;
  seen_ = quality >= kGoodMouth;
  if (!active_) {
    if (down && let_go_ && now - *held_since_ >= kHold) Start(quality, tuning, now);
    return;
  }
  Follow(tuning, now);
  if (pushes.escapes != before.escapes || now - idle_since_ >= kPatience) return Leave(tuning);
  if (pushes.takes != before.takes && !taking_) BeginPose(tuning, now);
}

void Guide::Start(float quality, Tuning& tuning, Time now) {
  Log("lips: a calibration begins at the box");
  active_ = true;
  let_go_ = false;
  step_ = 0;
  taking_ = false;
  progress_ = 0;
  before_ = tuning.report().changes;
  idle_since_ = now;
  tuning.Do({.ask = Ask::kStop}, now);
  tuning.Do({.ask = Ask::kLight, .a = 1}, now);
  if (quality < kCleanMouth) tuning.Do({.ask = Ask::kFind}, now);
}

// A pose that is done has changed something; one that was given up, by a desk, is asked for again.
void Guide::Follow(Tuning& tuning, Time now) {
  const Report& report = tuning.report();
  progress_ = report.progress;
  if (!taking_ || report.step) return;
  taking_ = false;
  progress_ = 0;
  idle_since_ = now;
  if (report.changes != before_step_) ++step_;
}

void Guide::BeginPose(Tuning& tuning, Time now) {
  idle_since_ = now;
  if (step_ == kKeep) {
    tuning.Do({.ask = Ask::kSave}, now);
    active_ = false;
    return;
  }
  if (step_ == 0) tuning.Do({.ask = Ask::kLight, .a = 0}, now);
  before_step_ = tuning.report().changes;
  taking_ = true;
  tuning.Do({.ask = Ask::kBegin, .name = std::string(NameOf(static_cast<CalibrationStep>(step_)))}, now);
}

void Guide::Leave(Tuning& tuning) {
  Log("lips: the calibration at the box is left; all is as before");
  tuning.TakeBackTo(before_);
  tuning.Do({.ask = Ask::kLight, .a = 0}, idle_since_);
  active_ = false;
}

board::LipsGuide Guide::shown(bool captions) const {
  return {.step = step_,
          .taking = taking_ ? 1U : 0U,
          .progress = progress_,
          .seen = seen_ ? 1U : 0U,
          .captions = captions ? 1U : 0U};
}

}  // namespace kaori::lips
