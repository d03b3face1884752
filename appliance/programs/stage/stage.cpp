#include "appliance/programs/stage/stage.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "appliance/core/board/performance_state.h"
#include "appliance/core/performance/levels.h"
#include "appliance/core/performance/motions.h"
#include "appliance/core/performance/recall.h"
#include "appliance/programs/stage/service_display.h"
#include "appliance/programs/stage/show_now.h"
#include "drivers/base/log.h"
#include "drivers/base/start_watch.h"

namespace kaori::stage {
namespace {

constexpr Duration kSecond = std::chrono::seconds(1);
constexpr std::uint64_t kFirstFrames = 100;  // Among them are those that compile shaders.
// The age of the lips is logged again when it has changed by a quarter and 5 ms, every ten seconds at most.
constexpr Duration kSameAge = std::chrono::milliseconds(5);
constexpr Duration kAgeQuiet = std::chrono::seconds(10);
constexpr Duration kOldestInput = std::chrono::hours(1);             // What is older is as old.
constexpr Duration kFarthestAhead = std::chrono::milliseconds(100);  // A screen that promises more is wrong.

// Time of all threads of the process, Mesa's included, in user and kernel.
Duration CpuOfProcess() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto time = [](const timeval& t) {
    return std::chrono::seconds(t.tv_sec) + std::chrono::microseconds(t.tv_usec);
  };
  return time(usage.ru_utime) + time(usage.ru_stime);
}

// The newest stamp of what moves the face by hand or lips. A voice writes without a pause and would hide all
// others.
Time NewestInput(const board::Snapshot& s) {
  return std::max({s.surface.at, s.sticks[0].at, s.sticks[1].at, s.keys.at, s.lips.at, s.pointer.at});
}

// The expected state of a screen that has no room for a picture, or no flip to tell of.
bool Waits(const Error& error) {
  return error.cause == std::errc::resource_unavailable_try_again;
}

}  // namespace

// The count of frames and the last motion go on from the board, so that readers who compare them see no step
// back.
Stage::Stage(const board::Board& board, StageWriters writers, Studio& studio, const Clock& clock)
    : board_(board), snapshots_(board), writers_(std::move(writers)), studio_(studio), clock_(clock) {
  auto kept = board::Restore<performance::State>(board.Read<board::Performance>().value);
  resumed_ = kept && performance::IsValid(*kept, studio.show());
  if (resumed_) performance::AdoptRoles(*kept, studio.show().roles);
  state_ = resumed_ ? *kept : performance::Opening(studio.show(), board::ReadAll(board), clock.now());
  act_clock_.emplace(board.Read<board::ShowNow>(), studio.show().cue_list, state_.cue_run.active);
  status_.frames = board.Read<board::StageStatus>().value.frames;
  motion_now_ = board.Read<board::MotionNow>().value;
  writers_.button_calls.Write(ButtonCallsOf(studio.show()), clock.now(), board::SourceState::kLive);
  pacer_.Set(false);
}

// The window goes before its screen: EGL would draw into memory that is gone.
void Stage::SetScreen(std::unique_ptr<ports::Scanout> screen) {
  studio_.CloseWindow();
  screen_ = std::move(screen);
  pacer_.Forget();
  plan_.reset();
}

// Flips first: they free a buffer, and say when the next blank comes. Any error but Waits means that the
// screen is gone, whatever it says.
void Stage::Step() {
  if (!screen_) return;
  auto done = HandleFlips();
  if (done) done = DrawWhenDue();
  if (done || Waits(done.error())) return;
  Log("the screen is gone ({}); playing on without it", done.error().message());
  SetScreen(nullptr);
}

// No status is written: a stage that nobody sees counts as dead for the tally lamp.
void Stage::StepUnseen() {
  const Time now = clock_.now();
  Perform(ReadBoard(now), now);
}

// The state counts the controls of the roles that were played until now.
void Stage::HandOver(const show::Roles& next) {
  performance::BeginLevels(state_, next);
  writers_.performance.Write(board::Hold(state_), clock_.now(), board::SourceState::kLive);
}

// While the board settles on a new file its counters are adopted, not differenced.
const board::Snapshot& Stage::ReadBoard(Time now) {
  const board::Snapshot& snapshot = snapshots_.Read(now);
  if (snapshots_.settling()) performance::ForgetCounters(state_.seen);
  return snapshot;
}

// All that wait: after a late turn there may be more than one.
Result<void> Stage::HandleFlips() {
  while (true) {
    const auto flip = screen_->ReadFlip();
    if (!flip && Waits(flip.error())) return {};
    if (!flip) return tl::unexpected(flip.error());
    NoteFlip(*flip);
  }
}

// Only the newest frame's sampling time is known; a flip of an older one says nothing of it.
void Stage::NoteFlip(const ports::Flip& flip) {
  pacer_.Flipped(flip);
  mouth_clock_.Flip(flip);
  status_.missed_flips = pacer_.missed();
  if (flip.frame != frame_) return;
  status_.flipped_at = flip.at;
  status_.sampled_at = read_;
}

// Without a plan the screen has no room for a picture, and its descriptor wakes the loop.
std::optional<Time> Stage::wakes_at() const {
  return screen_ && plan_ ? std::optional(plan_->begin) : std::nullopt;
}

// The first frames compile shaders, and say little of those that follow. The limits are those of the steps of the start.
Duration Stage::usual_turn() const {
  constexpr int kPatientTurns = service::Watchdog::kPatientTurns;
  if (frame_ == 0) return {};
  const Duration silence =
      std::max(slowest_turn_ * service::StartWatch::kPatientSteps, service::StartWatch::kLeast);
  const Duration most = (silence + Duration(kPatientTurns - 1)) / kPatientTurns;  // Rounded up.
  return frame_ >= kFirstFrames ? std::min(pacer_.usual(), most) : most;
}

// The plan stands until its frame is drawn: a late waking is late, and not a plan for another blank.
Result<void> Stage::DrawWhenDue() {
  const auto picture = screen_->Acquire();
  if (!picture) return tl::unexpected(picture.error());
  if (!plan_) plan_ = pacer_.Next(clock_.now());
  if (clock_.now() < plan_->begin) return {};
  return Draw(*picture);
}

// The order is what makes the input fresh: the board is read here, right before drawing and not when the plan
// was made. The plan's time is bounded, since a screen's word is not believed without limit. What may wait
// comes after Present: the report, the last face, and the rehearsal of one more shader, which begins with the
// second frame: the first one is to be told of at once.
Result<void> Stage::Draw(const ports::PixelBuffer& picture) {
  const FramePacer::Plan plan = *std::exchange(plan_, std::nullopt);
  const Duration cpu_before = CpuOfProcess();
  const Time now = clock_.now();
  const Time presented_at = std::clamp(plan.presented_at, now, now + kFarthestAhead);
  read_ = now;
  const board::Snapshot& snapshot = ReadBoard(now);
  const scene::Scene scene = Perform(snapshot, presented_at);
  if (auto drawn = studio_.Draw(scene, picture); !drawn) return drawn;
  if (editor_)
    editor_->Look(studio_.show().cast, studio_.shape(), scene,
                  static_cast<float>(picture.width_px) / static_cast<float>(picture.height_px));
  if (auto shown = screen_->Present(++frame_); !shown) return shown;
  mouth_clock_.Present(frame_, snapshot, state_);
  pacer_.Drawn(plan, clock_.now());
  Report(snapshot, CpuOfProcess() - cpu_before);
  if (after_frame_) after_frame_(state_, scene, clock_.now());
  if (frame_ > 1 && studio_.Prepare()) Log("all drawing is rehearsed");
  slowest_turn_ = std::max(slowest_turn_, clock_.now() - now);
  return {};
}

// The editor takes its events first; what is left plays. Expressions that it changed are renewed before the
// frame is animated, so that a pull is seen in the frame that reads it.
performance::Performed Stage::Animate(const board::Snapshot& snapshot, performance::InputEvents& events,
                                      Time presented_at) {
  if (!editor_) return AnimateAndNote(snapshot, events, presented_at, /*changed=*/false);
  const performance::State before = state_;
  const board::Snapshot& rest = PlayEditor(snapshot, events, presented_at);
  for (const auto& [index, work] : editor_->renewed()) studio_.Renew(index, work->pulls_m, work->lids);
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): see AnimateAndNote.
  const bool changed = std::memcmp(&before, &state_, sizeof(state_)) != 0;
  auto performed = AnimateAndNote(rest, events, presented_at, changed);
  editor_->Describe(performed.scene);
  return performed;
}

// An editor that was open when the lock came on is shut, and its work stays in it and in its journal.
const board::Snapshot& Stage::PlayEditor(const board::Snapshot& snapshot, performance::InputEvents& events,
                                         Time presented_at) {
  performance::InputEvents none;
  if (state_.locked != 0) editor_->Close();
  return editor_->Play(snapshot, state_.locked != 0 ? none : events, studio_.show(), state_, presented_at);
}

// Bytes of the state that are no field may differ: a state that is noted once too often only takes room.
performance::Performed Stage::AnimateAndNote(const board::Snapshot& snapshot,
                                             const performance::InputEvents& events, Time presented_at,
                                             bool changed) {
  auto performed = performance::Animate(state_, snapshot, events, studio_.show(), presented_at);
  if (log_ != nullptr) log_->Note({presented_at, snapshot, state_, events, changed}, performed);
  return performed;
}

const board::Snapshot& Stage::WithEvening(const board::Snapshot& live, Time presented_at) {
  if (!std::exchange(evening_began_, true)) state_ = evening_->Begin(presented_at);
  laid_ = live;
  if (evening_->Lay(presented_at, laid_)) return laid_;
  Log("the evening from the log is over: all operators are live");
  evening_.reset();
  state_.seen = performance::SeenOn(laid_);  // What was called meanwhile was not heard, and is over.
  return laid_;
}

// One frame of the show without drawing. Events are handed on in this order: calibration, line check
// or learn mode, editor, performance; each takes out what it uses. The state goes to the board with every frame: that is
// what a stage which is killed resumes from.
scene::Scene Stage::Perform(const board::Snapshot& live, Time presented_at) {
  const board::Snapshot& snapshot = evening_ ? WithEvening(live, presented_at) : live;
  performance::InputEvents events = performance::ReadEvents(state_.seen, snapshot);
  local_time_.Tell(studio_.show(), state_.lobby, clock_.now(), events);
  const bool guiding = IsGuiding(snapshot.lips_guide, presented_at);
  if (guiding) ConsumeGuideInput(events);
  const board::Snapshot& left =
      service_.Step({board_, live, snapshot, studio_.show(), state_, screen_.get(), presented_at}, events);
  auto performed = Animate(left, events, presented_at);
  performed.lamps = service_.lamps(presented_at).value_or(performed.lamps);
  if (guiding) performed.lamps = GuideLamps(snapshot.lips_guide.value, presented_at);
  ShowService(snapshot, presented_at, performed.scene);
  if (service_.learner().running()) Say(service_.learner().Lines(), performed.scene.caption);
  if (!notice_.empty()) Say(notice_, performed.scene.caption);
  call_log_.Tell(state_, performed.state, studio_.show(), presented_at);
  state_ = performed.state;
  writers_.performance.Write(board::Hold(state_), presented_at, board::SourceState::kLive);
  const Time act_began = act_clock_->Step(studio_.show().cue_list, state_.cue_run.active, presented_at);
  writers_.show_now.Write(ShowNowOf(state_, studio_.show(), act_began), presented_at,
                          board::SourceState::kLive);
  WriteMotionNow(presented_at);
  if (performed.lamps != snapshot.lamps.value.lit || snapshot.lamps.source != board::SourceState::kLive)
    writers_.lamps.Write({performed.lamps}, presented_at, board::SourceState::kLive);
  return std::move(performed.scene);
}

// While a motion with a sound plays, and once when none does any more.
void Stage::WriteMotionNow(Time presented_at) {
  const performance::Playing* plays = performance::Sounding(state_, studio_.show());
  if (state_.cue_run.paused != 0) plays = nullptr;
  if (plays == nullptr && motion_now_.motion < 0) return;
  const bool begins =
      plays != nullptr && (plays->motion != motion_now_.motion || plays->at_s < motion_now_.at_s);
  motion_now_ = {plays != nullptr ? plays->motion : -1, plays != nullptr ? plays->at_s : 0,
                 motion_now_.starts + (begins ? 1 : 0)};
  writers_.motion_now.Write(motion_now_, presented_at, board::SourceState::kLive);
}

// When the age is known, and when it has become another one.
void Stage::LogLipsAge(Time now) {
  const Duration age = status_.lips_age, more = std::max(age, logged_age_);
  const bool same = more - std::min(age, logged_age_) < more / 4 + kSameAge;
  if (age == Duration{} || same || now < age_quiet_until_) return;
  logged_age_ = age;
  age_quiet_until_ = now + kAgeQuiet;
  Log("lips are {:.0f} ms old when they are presented, and the mouth follows {:.0f} ms after them",
      Seconds(age) * 1e3, Seconds(status_.mouth_lag) * 1e3);
}

// Means are over a second at least; the first one begins with the first frame. Ages are bounded: a board on
// which nothing was ever written has stamps of the machine's start.
void Stage::Report(const board::Snapshot& snapshot, Duration cpu) {
  const Time now = clock_.now();
  if (second_.frames == 0 && second_.began == Time{}) second_.began = state_.last;
  ++status_.frames;
  ++second_.frames;
  second_.cpu += cpu;
  if (const Duration passed = now - second_.began; passed >= kSecond) {
    status_.frames_per_s = static_cast<float>(second_.frames / Seconds(passed));
    status_.frame_cpu = second_.cpu / second_.frames;
    mouth_clock_.Report(status_);
    LogLipsAge(now);
    second_ = {now, 0, {}};
  }
  status_.face = state_.faces.to;
  status_.expression = state_.expressions.to;
  status_.style = state_.styles.to;
  status_.scene = state_.scene;
  status_.quality = static_cast<std::uint32_t>(studio_.quality());
  status_.input_age = std::clamp(state_.last - NewestInput(snapshot), Duration{}, kOldestInput);
  status_.draw = pacer_.usual();
  status_.margin = pacer_.margin();
  writers_.status.Write(status_, now, board::SourceState::kLive);
}

}  // namespace kaori::stage
