#include "appliance/programs/editor/hands.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/programs/editor/keys.h"

namespace kaori::editor {
namespace {

using namespace std::chrono_literals;

constexpr float kPullPerTurn_m = 0.010F;
constexpr float kPullPerNotch_m = 0.0005F;
constexpr float kScalePerTurn = 2;  // A turn doubles the expression, or halves it.
constexpr float kLidsPerTurn = 1;
constexpr Duration kPause = 800ms;  // A hand that rests so long begins a new step.

constexpr float kStickGoes = 0.6F;    // Pushed so far a stick goes to the next needle,
constexpr float kStickRests = 0.35F;  // and let back so far it may go again.
constexpr Duration kFirstRepeat = 450ms, kNextRepeat = 180ms;

constexpr std::size_t kLongestName = 24;

// Kinds of gestures that are not a dial.
constexpr int kWheelGesture = 100, kDragGesture = 101;

}  // namespace

char TypedBy(std::uint8_t usage, bool shift) {
  if (usage >= key::kA && usage < key::k1) return static_cast<char>((shift ? 'A' : 'a') + (usage - key::kA));
  if (usage == key::k0) return '0';
  if (usage >= key::k1 && usage < key::k0) return static_cast<char>('1' + (usage - key::k1));
  return usage == key::kMinus || usage == key::kSpace ? '_' : '\0';
}

struct Hands::Reading {
  const board::Snapshot& board;
  const performance::Seen& seen;
  const show::Show& show;
  bool open;
  Time now;
  std::vector<Command> commands{};

  void Do(Verb verb, int index = 0) { commands.push_back({.verb = verb, .index = index}); }
  void Go(glm::vec2 direction) { commands.push_back({.verb = Verb::kGo, .a = direction}); }
};

std::vector<Command> Hands::Read(const board::Snapshot& board, const performance::Seen& seen,
                                 const show::Show& show, bool open, Time now) {
  Reading reading{board, seen, show, open, now};
  const auto there = [](const auto& section) { return section.source != board::SourceState::kAbsent; };
  if (!open) typing_.reset();
  if (there(board.keys)) ReadKeys(reading);
  comparing_ = open && !typing_ && there(board.keys) && IsDown(board.keys.value, key::kC);
  if (open && there(board.surface)) {
    ReadButtons(reading);
    ReadDials(reading);
  }
  if (open) ReadStick(reading);
  if (there(board.pointer)) ReadPointer(reading);
  const auto chooses = [](const Command& command) { return command.verb == Verb::kGo; };
  if (std::ranges::any_of(reading.commands, chooses)) EndGesture();  // Another needle, another step.
  return std::move(reading.commands);
}

void Hands::AskForName(Typing::For purpose, std::string text) {
  typing_ = Typing{purpose, std::move(text)};
}

void Hands::ReadKeys(Reading& reading) {
  const auto& pushes = reading.board.keys.value.pushes;
  for (std::size_t usage = 0; usage < pushes.size(); ++usage)
    if (pushes[usage] != reading.seen.keys[usage]) ReadKey(reading, static_cast<std::uint8_t>(usage));
}

void Hands::ReadKey(Reading& reading, std::uint8_t usage) {
  const bool shift = ShiftIsDown(reading.board.keys.value);
  if (typing_) return Type(reading, usage);
  if (usage == key::kTab) return reading.Do(Verb::kToggle);
  if (shift && PlaceOfDigit(usage) >= 0) return reading.Do(Verb::kPlace, PlaceOfDigit(usage));
  if (!reading.open) return;
  switch (usage) {
    case key::kRight:
      return reading.Go({1, 0});
    case key::kLeft:
      return reading.Go({-1, 0});
    case key::kUp:
      return reading.Go({0, 1});
    case key::kDown:
      return reading.Go({0, -1});
    case key::kM:
      return reading.Do(Verb::kMirror);
    case key::kS:
      return reading.Do(Verb::kSmooth);
    case key::kH:
      return reading.Do(Verb::kHelp);
    case key::kZ:
      return reading.Do(shift ? Verb::kRedo : Verb::kUndo);
    case key::kY:
      return reading.Do(Verb::kRedo);
    case key::kBackspace:
      return reading.Do(Verb::kZero);
    case key::kP:
      return reading.Do(Verb::kTakeInPlay);
    case key::k0:
      return reading.Do(Verb::kTake, 0);
    case key::kN:
      return reading.Do(Verb::kAskName);
    case key::kEnter:
    case key::kPadEnter:
      return reading.Do(shift ? Verb::kSaveAsNew : Verb::kSave);
    case key::kDelete:
      return reading.Do(Verb::kDelete);
    default:
      return ReadKeyCall(reading, usage);
  }
}

void Hands::ReadKeyCall(Reading& reading, std::uint8_t usage) {
  for (const show::KeyCall& key : reading.show.keys)
    if (key.key_usage == usage && key.call.kind == show::CallKind::kExpression)
      reading.Do(Verb::kTake, key.call.index);
}

void Hands::Type(Reading& reading, std::uint8_t usage) {
  std::string& text = typing_->text;
  if (usage == key::kEscape || usage == key::kTab) return typing_.reset();
  if (usage == key::kBackspace) {
    if (!text.empty()) text.pop_back();
    return;
  }
  if (usage == key::kEnter || usage == key::kPadEnter) {
    const bool only_name = typing_->purpose == Typing::For::kName;
    reading.commands.push_back({.verb = only_name ? Verb::kName : Verb::kNameAndSave,
                                .index = typing_->purpose == Typing::For::kSaveAsNew ? 1 : 0,
                                .text = text});
    return typing_.reset();
  }
  const char typed = TypedBy(usage, ShiftIsDown(reading.board.keys.value));
  if (typed != '\0' && text.size() < kLongestName) text += typed;
}

// A call of an expression takes it into work; the other calls are the performance's.
void Hands::ReadButtons(Reading& reading) {
  const auto& pushes = reading.board.surface.value.pushes;
  for (std::size_t i = 0; i < pushes.size(); ++i)
    if (pushes[i] != reading.seen.buttons[i] && reading.show.buttons[i].kind == show::CallKind::kExpression)
      reading.Do(Verb::kTake, reading.show.buttons[i].index);
}

void Hands::ReadDials(Reading& reading) {
  const board::Surface& surface = reading.board.surface.value;
  const auto per_turn = static_cast<float>(std::max(1, surface.counts_per_turn));
  for (std::size_t which = 0; which < kTakenDials.size(); ++which) {
    const std::size_t dial = kTakenDials[which];
    const auto moved = static_cast<std::int32_t>(static_cast<std::uint32_t>(surface.counts[dial]) -
                                                 static_cast<std::uint32_t>(reading.seen.dials[dial]));
    if (moved == 0) continue;
    const float turns = static_cast<float>(moved) / per_turn;
    Command command{.gesture = GestureOf(static_cast<int>(which), reading.now)};
    if (which < 3) {
      command.verb = Verb::kPull;
      command.by_m[static_cast<int>(which)] = turns * kPullPerTurn_m;
    } else if (which == 3) {
      command.verb = Verb::kScale;
      command.amount = std::pow(kScalePerTurn, turns);
    } else {
      command.verb = Verb::kShutLids;
      command.amount = turns * kLidsPerTurn;
    }
    reading.commands.push_back(std::move(command));
  }
}

void Hands::ReadStick(Reading& reading) {
  const auto& stick = reading.board.sticks[1];
  const glm::vec2 way{stick.value.x, stick.value.y};
  const float far = stick.source == board::SourceState::kLive ? glm::length(way) : 0.0F;
  if (far < kStickRests) next_step_.reset();
  if (far < kStickGoes || (next_step_ && reading.now < *next_step_)) return;
  reading.Go(way);
  next_step_ = reading.now + (next_step_ ? kNextRepeat : kFirstRepeat);
}

void Hands::ReadPointer(Reading& reading) {
  const board::Pointer& now = reading.board.pointer.value;
  const board::Pointer before = pointer_.value_or(now);
  pointer_ = now;
  if (!reading.open) {
    dragging_ = false;
    return;
  }
  if (now.pushes[0] != before.pushes[0]) {
    reading.commands.push_back({.verb = Verb::kPress, .a = {now.x, now.y}});
    EndGesture();
  }
  dragging_ = (now.buttons_down & 1U) != 0 && (dragging_ || now.pushes[0] != before.pushes[0]);
  const glm::vec2 step{now.x - before.x, now.y - before.y};
  if (dragging_ && now.pushes[0] == before.pushes[0] && step != glm::vec2{})
    reading.commands.push_back(
        {.verb = Verb::kDrag, .a = step, .gesture = GestureOf(kDragGesture, reading.now)});
  if (dragging_) gesture_at_ = reading.now;  // It lasts until the button is let go, however long that rests.
  const int notches = now.wheel - before.wheel;
  if (notches != 0)
    reading.commands.push_back({.verb = Verb::kPull,
                                .by_m = {0, 0, static_cast<float>(notches) * kPullPerNotch_m},
                                .gesture = GestureOf(kWheelGesture, reading.now)});
}

// The same hand, without a long rest: the same gesture.
Gesture Hands::GestureOf(int kind, Time now) {
  if (kind != gesture_kind_ || now - gesture_at_ > kPause) ++last_gesture_;
  gesture_kind_ = kind;
  gesture_at_ = now;
  return last_gesture_;
}

}  // namespace kaori::editor
