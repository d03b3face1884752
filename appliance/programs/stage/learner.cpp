#include "appliance/programs/stage/learner.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/board/keys.h"
#include "appliance/core/board/lines.h"
#include "appliance/programs/stage/withheld.h"
#include "drivers/base/log.h"

namespace kaori::stage {
namespace {

namespace key = board::key;
using board::CheckedItem;
using board::LearnCall;
using board::LearnPhase;

constexpr Duration kNobodyTeaches = std::chrono::minutes(2);
// kaori-input looks every 5 ms and writes a file of some lines.
constexpr Duration kLongestTurnKeeping = std::chrono::seconds(5);

bool IsSame(const CheckedItem& a, const CheckedItem& b) {
  return a.kind == b.kind && a.device == b.device && a.number == b.number;
}

// An axis or a dial, as roles have it.
show::NamedControl ControlOf(const CheckedItem& item) {
  if (item.kind == board::CheckedKind::kDial)
    return {show::Control::kDial, static_cast<std::uint8_t>(item.number)};
  return {static_cast<show::Control>(item.number), 0};
}

// On either sheet; a stick has none.
std::array<show::Call, 2> CallsNow(std::size_t button, const show::Show& show) {
  if (button < show.buttons.size()) return {show.buttons[button], show.second_buttons[button]};
  return {show.stick_buttons[button - show.buttons.size()], {}};
}

// What a key asks for. The key that begins it ends it too.
std::optional<LearnCall> CallOfKey(std::uint8_t code, bool running) {
  if (code == key::kEnd) return running ? LearnCall::kEnd : LearnCall::kBegin;
  if (!running) return std::nullopt;
  if (code == key::kEscape) return LearnCall::kEnd;
  if (code == key::kEnter || code == key::kPadEnter) return LearnCall::kKeep;
  if (code == key::kLeft || code == key::kRight) return LearnCall::kTurnRound;
  return std::nullopt;
}

}  // namespace

const board::Snapshot& Learner::Step(const Frame& frame, performance::InputEvents& events) {
  const Wish wish = ReadWish(events);
  if (!running_ && wish.call == LearnCall::kBegin && MayBegin(frame)) Begin(frame);
  if (!running_) return frame.snapshot;
  Do(wish, frame);
  Look(frame);
  if (now_.phase != LearnPhase::kKeeping) EndWhereDue(frame);
  writer_.Write(now_, frame.now, board::SourceState::kLive);
  left_ = frame.snapshot;
  if (running_) Withhold();
  ConsumeAll(events);  // Also in the last frame: what was pushed until the end is not the show's.
  return left_;
}

// Not while the file is written, which takes no longer than the disk does: what was kept is to be known.
void Learner::EndWhereDue(const Frame& frame) {
  if (ends_)
    End("");
  else if (!board::IsServiceKeyOn(frame.live.lines))
    End(", since the service key is off");
  else if (frame.now - changed_at_ >= kNobodyTeaches)
    End(", since nothing was moved for two minutes");
}

// Calls of learn mode are its own, whether it runs or not. Without it the key that begins it alone is; the
// others play.
Learner::Wish Learner::ReadWish(performance::InputEvents& events) const {
  Wish wish;
  events.ConsumeCalls([&](const board::Call& call) {
    if (call.verb != board::CallVerb::kLearn) return false;
    if (call.subject > static_cast<std::uint32_t>(LearnCall::kTurnRefused)) return true;
    const auto what = static_cast<LearnCall>(call.subject);
    (what > LearnCall::kTurnRound ? wish.answer : wish.call) = what;
    if (what == LearnCall::kBegin && call.value >= 0 && call.value < static_cast<float>(ChoiceCount()))
      wish.choice = static_cast<std::uint32_t>(call.value);
    return true;
  });
  events.Consume([&](const performance::Press& press) {
    if (!press.IsKey()) return false;
    if (press.code == key::kUp) --wish.step;
    if (press.code == key::kDown) ++wish.step;
    const auto call = CallOfKey(press.code, running_);
    if (call) wish.call = call;
    return running_ || call.has_value();
  });
  return wish;
}

bool Learner::MayBegin(const Frame& frame) const {
  if (!board::IsServiceKeyOn(frame.live.lines))
    LogWarning("learn mode does not begin: the service key is off");
  else if (own_.file.empty())
    LogWarning("learn mode does not begin: this stage keeps no roles of its own");
  else if (&frame.live != &frame.snapshot)
    LogWarning("learn mode does not begin: an evening from the log plays, with the roles of then");
  else
    return true;
  return false;
}

void Learner::Begin(const Frame& frame) {
  running_ = true;
  if (!file_) file_.emplace(own_);
  for (std::size_t i = 0; i < sliders_.size(); ++i) sliders_[i] = frame.live.sticks[i].value.slider;
  Choose(std::min(now_.choice, ChoiceCount() - 1), frame);
  Log("learn mode begins; nothing of what is moved moves the face until it ends");
}

void Learner::Choose(std::uint32_t choice, const Frame& frame) {
  now_ = {.phase = LearnPhase::kAsking, .choice = choice};
  found_.reset();
  lesson_.reset();
  changed_at_ = frame.now;
  controls_.Begin(frame.live, frame.now);
  buttons_.Begin(frame.live, frame.now);
  turns_.Begin(frame.live, frame.now);
}

// While the file is written nothing else is begun, so that what is shown is what is kept.
void Learner::Do(const Wish& wish, const Frame& frame) {
  ends_ = ends_ || wish.call == LearnCall::kEnd;
  answer_ = wish.answer ? wish.answer : answer_;
  if (now_.phase == LearnPhase::kKeeping) return;
  const auto count = static_cast<int>(ChoiceCount());
  if (wish.choice) return Choose(*wish.choice, frame);
  if (wish.step != 0) {
    const int choice = (static_cast<int>(now_.choice) + wish.step % count + count) % count;
    return Choose(static_cast<std::uint32_t>(choice), frame);
  }
  if (!IsFound()) return;
  if (wish.call == LearnCall::kTurnRound && !IsCall() && !IsTurn()) {
    now_.inverted ^= 1U;
    Propose(frame);
  }
  if (wish.call == LearnCall::kKeep) Keep(frame);
}

void Learner::Look(const Frame& frame) {
  if (IsTurn()) return LookAtTurns(frame);
  if (now_.phase == LearnPhase::kKeeping) {
    if (file_->busy()) return;
    changed_at_ = frame.now;
    now_.phase = file_->failed() ? LearnPhase::kRefused : LearnPhase::kKept;
    if (!file_->failed()) kept_ = file_->laid();
    return;
  }
  controls_.Look(frame.live, frame.now);
  buttons_.Look(frame.live, frame.now);
  const bool call = IsCall();
  const auto restless = call ? buttons_.restless() : controls_.restless(frame.now);
  now_.restless = restless ? 1 : 0;
  now_.moves_itself = restless.value_or(CheckedItem{});
  now_.ambiguous = (call ? buttons_.ambiguous() : controls_.ambiguous()) ? 1 : 0;
  const auto& found = call ? buttons_.found() : controls_.found();
  changed_at_ = std::max({changed_at_, buttons_.changed_at(), controls_.changed_at()});
  // After a level was kept the next one is to be picked first.
  if (!found || now_.phase == LearnPhase::kKept || (found_ && IsSame(*found, *found_))) return;
  found_ = found;
  now_.inverted = 0;
  Propose(frame);
}

// Whoever turns once more measures anew, until it is kept.
void Learner::LookAtTurns(const Frame& frame) {
  if (now_.phase == LearnPhase::kKeeping) return AwaitTurnKept(frame);
  turns_.Look(frame.live, frame.now);
  changed_at_ = std::max(changed_at_, turns_.changed_at());
  now_.ambiguous = turns_.ambiguous() ? 1 : 0;
  const auto& turn = turns_.found();
  if (!turn || now_.phase == LearnPhase::kKept) return;
  const bool is_known = now_.turn_counts == turn->counts && IsSame(now_.found, turn->dial);
  if (is_known && now_.phase != LearnPhase::kAsking) return;
  now_.found = turn->dial;
  now_.turn_counts = turn->counts;
  now_.phase = LearnPhase::kFound;
}

// Its answer is a call, which comes at once where it is there: what takes longer is a program that is away.
// The device is kaori-input's, and so is what it has learnt of it.
void Learner::AwaitTurnKept(const Frame& frame) {
  if (!answer_ && frame.now - changed_at_ < kLongestTurnKeeping) return;
  const bool kept = answer_ == LearnCall::kTurnKept;
  if (!kept)
    LogWarning("what one turn has is not kept: {}",
               answer_ ? "the log of kaori-input says why" : "kaori-input does not answer");
  now_.phase = kept ? LearnPhase::kKept : LearnPhase::kRefused;
  now_.turn_lesson = 0;
  changed_at_ = frame.now;
}

void Learner::Propose(const Frame& frame) {
  now_.found = *found_;
  changed_at_ = frame.now;
  lesson_.reset();
  instead_.clear();
  IsCall() ? ProposeButton(frame) : ProposeControl(frame);
  now_.phase = lesson_ ? LearnPhase::kFound : LearnPhase::kUnfit;
  now_.instead = instead_.empty() ? 0 : 1;
}

void Learner::ProposeControl(const Frame& frame) {
  const auto level =
      now_.choice < show::kNamedLevels ? static_cast<show::Level>(now_.choice) : show::MixLevel(0);
  const auto map = roles::MapOfWhole(level, ControlOf(*found_), now_.inverted != 0);
  if (!map) return;
  const roles::Taught taught{NameOfChoice(), static_cast<show::Device>(found_->device), *map};
  instead_ = roles::OtherLevelsOf(kept_ ? *kept_ : frame.show.roles, own_.items, taught);
  lesson_ = taught;
}

// What the show plays stays as it was until the stage starts again: a button that was taught a moment ago is
// said to call what it called before.
void Learner::ProposeButton(const Frame& frame) {
  const roles::NamedButton named{static_cast<show::Device>(found_->device),
                                 static_cast<int>(found_->number) + 1};
  const roles::TaughtButton taught{roles::ButtonNamed(named), NameOfChoice()};
  for (const show::Call& call : CallsNow(taught.button, frame.show)) {
    if (call.kind == show::CallKind::kNothing) continue;
    std::string name = roles::NameOf(call, own_.items);
    if (name.empty()) name = "what it calls now";
    if (name != taught.call && std::ranges::find(instead_, name) == instead_.end())
      instead_.push_back(std::move(name));
  }
  lesson_ = taught;
}

void Learner::Keep(const Frame& frame) {
  now_.phase = LearnPhase::kKeeping;
  changed_at_ = frame.now;
  if (IsTurn()) {
    // A number of its own, which a stage that starts again does not give a second time.
    const auto ms =
        std::chrono::duration_cast<std::chrono::milliseconds>(frame.now.time_since_epoch()).count();
    now_.turn_lesson = static_cast<std::uint32_t>(ms) | 1U;
    answer_.reset();
    return;
  }
  file_->Write(*lesson_);
  Log("{} is to {} {} from the next start of the stage on", board::NameOf(now_.found),
      IsCall() ? "call" : "play", NameOfChoice());
}

void Learner::End(const char* why) {
  now_.phase = LearnPhase::kEnded;
  running_ = ends_ = false;
  Log("learn mode has ended{}{}", why, kept_ ? "; the stage starts again with what was taught" : "");
}

// Sticks stand in their middle, and sliders where they stood when it began: devices that were taken away
// would be told of as lost.
void Learner::Withhold() {
  for (std::size_t i = 0; i < left_.sticks.size(); ++i) {
    board::Stick& stick = left_.sticks[i].value;
    stick.x = stick.y = stick.twist = 0;
    stick.hat = -1;
    stick.buttons_down = 0;
    stick.slider = sliders_[i];
  }
  Release(left_);
}

}  // namespace kaori::stage
