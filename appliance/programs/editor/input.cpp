#include "appliance/programs/editor/input.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/programs/editor/keys.h"
#include "appliance/programs/editor/own.h"

namespace kaori::editor {
namespace {

using namespace std::chrono_literals;

// A turn of a dial pulls by a centimetre, a notch of the wheel by half a millimetre.
constexpr float kPullPerTurn_m = 0.010F;
constexpr float kPullPerNotch_m = 0.0005F;
constexpr float kScalePerTurn = 2;  // A turn doubles the expression, or halves it.
// A turn shuts lids that were open all the way.
constexpr float kLidsPerTurn = 1;
constexpr Duration kPause = 800ms;  // A control that rests so long begins a new step.

constexpr float kStickGoes = 0.6F;    // Pushed so far a stick goes to the next handle,
constexpr float kStickRests = 0.35F;  // and let back so far it may go again.
constexpr Duration kFirstRepeat = 450ms, kNextRepeat = 180ms;

// Kinds of gestures that are not a dial.
// Dials are 0 to 4, by their place in kEditorDials.
constexpr int kWheelGesture = 100, kDragGesture = 101;

}  // namespace

// By positions of a US keyboard: HID says keys, and the layout of the keyboard is not known.
// '\0' for a key that types nothing which a name may have.
char TypedBy(std::uint8_t usage, bool shift) {
  if (usage >= key::kA && usage < key::k1) return static_cast<char>((shift ? 'A' : 'a') + (usage - key::kA));
  if (usage == key::k0) return '0';
  if (usage >= key::k1 && usage < key::k0) return static_cast<char>('1' + (usage - key::k1));
  return usage == key::kMinus || usage == key::kSpace ? '_' : '\0';
}

// One call of ReadPress or ReadMotion: what it looks at, and the commands so far. `show` is null where no
// press is read.
struct EditorInput::Reading {
  const show::Show* show;
  bool open;
  Time now;
  std::vector<Command> commands{};

  void Do(Verb verb, int index = 0) { commands.push_back({.verb = verb, .index = index}); }
};

// A button that calls an expression begins from it while the editor is open.
std::vector<Command> EditorInput::ReadPress(const performance::Press& press, const show::Show& show,
                                            const show::Call& button, bool open, Time now) {
  Reading reading{&show, open, now};
  if (press.IsKey()) {
    ReadKey(reading, press);
  } else if (open && button.kind == show::CallKind::kExpression) {
    reading.Do(Verb::kBeginFrom, button.index);  // Other calls are the performance's.
  }
  return std::move(reading.commands);
}

// Whether C is held is asked of the board and not of events, since it counts for as long as it is held. An
// absent pointer has its default position, which is no movement.
std::vector<Command> EditorInput::ReadMotion(const board::Snapshot& board,
                                             const performance::InputEvents& events, bool open, Time now) {
  Reading reading{nullptr, open, now};
  comparing_ = open && !typing_ && board.keys.source != board::SourceState::kAbsent &&
               IsDown(board.keys.value, key::kC);
  if (!open) {
    dragging_ = false;
    return {};
  }
  ReadDials(reading, events, board.surface.value.counts_per_turn);
  ReadStick(reading, board.sticks[1]);
  if (board.pointer.source != board::SourceState::kAbsent)
    ReadPointer(reading, events.pointer, board.pointer.value);
  return std::move(reading.commands);
}

void EditorInput::AskForName(Typing::For purpose, std::string text) {
  typing_ = Typing{purpose, std::move(text)};
}

void EditorInput::Go(Reading& reading, glm::vec2 direction) {
  reading.commands.push_back({.verb = Verb::kGo, .a = direction});
  EndGesture();  // Another handle, another step.
}

// A name that is typed has the keyboard to itself. Tab and Shift with a digit work while the editor is closed
// too. Keys that are none of the editor's may call an expression of the show: it is begun with.
void EditorInput::ReadKey(Reading& reading, const performance::Press& press) {
  const std::uint8_t usage = press.code;
  if (typing_) return Type(reading, press);
  if (usage == key::kTab) return reading.Do(Verb::kToggle);
  if (press.shift && SlotOfDigit(usage) >= 0) return reading.Do(Verb::kOwn, SlotOfDigit(usage));
  if (!reading.open) return;
  switch (usage) {
    case key::kRight:
      return Go(reading, {1, 0});
    case key::kLeft:
      return Go(reading, {-1, 0});
    case key::kUp:
      return Go(reading, {0, 1});
    case key::kDown:
      return Go(reading, {0, -1});
    case key::kM:
      return reading.Do(Verb::kMirror);
    case key::kS:
      return reading.Do(Verb::kSmooth);
    case key::kH:
      return reading.Do(Verb::kHelp);
    case key::kZ:
      return reading.Do(press.shift ? Verb::kRedo : Verb::kUndo);
    case key::kY:
      return reading.Do(Verb::kRedo);
    case key::kBackspace:
      return reading.Do(Verb::kZero);
    case key::kP:
      return reading.Do(Verb::kBeginFromPlay);
    case key::k0:
      return reading.Do(Verb::kBeginFrom, 0);
    case key::kN:
      return reading.Do(Verb::kAskName);
    case key::kEnter:
    case key::kPadEnter:
      return reading.Do(press.shift ? Verb::kSaveAsNew : Verb::kSave);
    case key::kDelete:
      return reading.Do(Verb::kDelete);
    default:
      break;
  }
  for (const show::KeyCall& call : reading.show->keys)
    if (call.key_usage == usage && call.call.kind == show::CallKind::kExpression)
      reading.Do(Verb::kBeginFrom, call.call.index);
}

// Letters beyond the longest name are left out, so that what stands there is what will be saved.
void EditorInput::Type(Reading& reading, const performance::Press& press) {
  const std::uint8_t usage = press.code;
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
  const char typed = TypedBy(usage, press.shift);
  if (typed != '\0' && text.size() < kLongestName) text += typed;
}

// The first three dials of kEditorDials pull along u, v and outwards; the fourth scales, by a power so that a
// turn back undoes a turn; the fifth shuts the lids.
void EditorInput::ReadDials(Reading& reading, const performance::InputEvents& events,
                            std::int32_t counts_per_turn) {
  const auto per_turn = static_cast<float>(std::max(1, counts_per_turn));
  for (std::size_t which = 0; which < kEditorDials.size(); ++which) {
    const std::int32_t moved = events.turned[kEditorDials[which]];
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

// As keys repeat: the first step at once, another after 0.45 s, and then one each 0.18 s while the stick is
// held.
void EditorInput::ReadStick(Reading& reading, const board::Stamped<board::Stick>& stick) {
  const glm::vec2 way{stick.value.x, stick.value.y};
  const float far = stick.source == board::SourceState::kLive ? glm::length(way) : 0.0F;
  if (far < kStickRests) next_step_.reset();
  if (far < kStickGoes || (next_step_ && reading.now < *next_step_)) return;
  Go(reading, way);
  next_step_ = reading.now + (next_step_ ? kNextRepeat : kFirstRepeat);
}

// A press chooses a handle, and only a drag that began with one pulls: a button that was down when the editor
// was opened does not.
void EditorInput::ReadPointer(Reading& reading, const performance::InputEvents::Pointer& moved,
                              const board::Pointer& held) {
  if (moved.pressed) {
    reading.commands.push_back({.verb = Verb::kPress, .a = *moved.pressed});
    EndGesture();
  }
  dragging_ = (held.buttons_down & 1U) != 0 && (dragging_ || moved.pressed);
  if (dragging_ && !moved.pressed && moved.moved != glm::vec2{})
    reading.commands.push_back(
        {.verb = Verb::kDrag, .a = moved.moved, .gesture = GestureOf(kDragGesture, reading.now)});
  if (dragging_) gesture_at_ = reading.now;  // It lasts until the button is let go, however long that rests.
  if (moved.notches != 0)
    reading.commands.push_back({.verb = Verb::kPull,
                                .by_m = {0, 0, static_cast<float>(moved.notches) * kPullPerNotch_m},
                                .gesture = GestureOf(kWheelGesture, reading.now)});
}

// The same control, without a long rest: the same gesture.
Gesture EditorInput::GestureOf(int kind, Time now) {
  if (kind != gesture_kind_ || now - gesture_at_ > kPause) ++last_gesture_;
  gesture_kind_ = kind;
  gesture_at_ = now;
  return last_gesture_;
}

}  // namespace kaori::editor
