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
    if (call.subject > static_cast<std::uint32_t>(LearnCall::kTurnRound)) return true;
    wish.call = static_cast<LearnCall>(call.subject);
    if (wish.call == LearnCall::kBegin && call.value >= 0 && call.value < static_cast<float>(ChoiceCount()))
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
}

// While the file is written nothing else is begun, so that what is shown is what is kept.
void Learner::Do(const Wish& wish, const Frame& frame) {
  ends_ = ends_ || wish.call == LearnCall::kEnd;
  if (now_.phase == LearnPhase::kKeeping) return;
  const auto count = static_cast<int>(ChoiceCount());
  if (wish.choice) return Choose(*wish.choice, frame);
  if (wish.step != 0) {
    const int choice = (static_cast<int>(now_.choice) + wish.step % count + count) % count;
    return Choose(static_cast<std::uint32_t>(choice), frame);
  }
  if (!IsFound()) return;
  if (wish.call == LearnCall::kTurnRound && !IsCall()) {
    now_.inverted ^= 1U;
    Propose(frame);
  }
  if (wish.call == LearnCall::kKeep) Keep(frame);
}

void Learner::Look(const Frame& frame) {
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

// Levels that every show has, faces and expressions as levels; then what buttons may call.
std::uint32_t Learner::ChoiceCount() const {
  const std::size_t items = own_.items.faces.size() + own_.items.expressions.size();
  return static_cast<std::uint32_t>(show::kNamedLevels + items + calls_.size());
}

bool Learner::IsCall() const {
  return now_.choice >= show::kNamedLevels + own_.items.faces.size() + own_.items.expressions.size();
}

// As files call it.
std::string Learner::NameOfChoice() const {
  std::size_t choice = now_.choice;
  if (choice < show::kNamedLevels) return std::string(show::kLevels[choice].name);
  choice -= show::kNamedLevels;
  const std::size_t items = own_.items.faces.size() + own_.items.expressions.size();
  if (choice >= items) return calls_[choice - items];
  if (choice < own_.items.faces.size()) return "face " + own_.items.faces[choice];
  return "expression " + own_.items.expressions[choice - own_.items.faces.size()];
}

std::vector<std::string> Learner::Lines() const {
  std::vector<std::string> lines{
      fmt::format("teach: what {} {}?", IsCall() ? "calls" : "plays", NameOfChoice())};
  const std::string control = board::NameOf(now_.found);
  switch (now_.phase) {
    case LearnPhase::kFound:
    case LearnPhase::kRefused:
      lines.push_back(control + (now_.inverted != 0 ? ", inverted" : ""));
      if (now_.instead != 0) lines.push_back(fmt::format("instead of {}", fmt::join(instead_, ", ")));
      if (now_.phase == LearnPhase::kRefused) lines.emplace_back("it could not be kept; see the log");
      lines.emplace_back(IsCall() ? "Enter keeps it   Esc ends"
                                  : "Enter keeps it   Left, Right turn it round   Esc ends");
      return lines;
    case LearnPhase::kUnfit:
      lines.push_back(control + " springs back, and this level rests at an end");
      break;
    case LearnPhase::kKeeping:
      lines.push_back(control + " is being kept");
      return lines;
    case LearnPhase::kKept:
      lines.push_back(control + " is kept");
      lines.emplace_back("Up, Down: another   Esc ends: the stage starts again with it");
      return lines;
    case LearnPhase::kNever:
    case LearnPhase::kAsking:
    case LearnPhase::kEnded:
      break;
  }
  if (now_.restless != 0) lines.push_back(board::NameOf(now_.moves_itself) + " does not rest");
  if (now_.ambiguous != 0) lines.emplace_back("two at once: move one alone");
  lines.push_back(
      fmt::format("{}   Up, Down: another   Esc ends", IsCall() ? "push a button" : "move a control"));
  return lines;
}

}  // namespace kaori::stage
