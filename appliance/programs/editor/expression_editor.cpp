#include "appliance/programs/editor/expression_editor.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "appliance/core/performance/ease.h"
#include "appliance/programs/editor/caption.h"
#include "appliance/programs/editor/keys.h"

namespace kaori::editor {
namespace {

using namespace std::chrono_literals;
using performance::Knob;

constexpr float kShow_per_s = 4;    // The handles come and go in a quarter of a second.
constexpr float kChange_s = 0.25F;  // An expression that opening or closing calls.
constexpr Duration kMessage = 4s;   // How long a message stands.
constexpr float kLongestStep_s = 0.1F;
// Skin that gives way further is not forced to follow a pointer: the pull would be more than four times the
// way of the pointer.
constexpr float kLeastYield = 0.25F;
constexpr glm::vec2 kPictureMiddle{0.5F, 0.5F};

void CallWhole(performance::State& state, std::uint16_t expression, float fade_s) {
  performance::Call(state.expressions, expression, fade_s, At(state.shown, Knob::kExpression));
  At(state.knobs, Knob::kExpression) = At(state.shown, Knob::kExpression) = 1;
}

}  // namespace

// What the commands of one frame work on; it lives as long as Play runs.
struct ExpressionEditor::Situation {
  const show::Show& show;
  performance::State& state;
  Time presented_at;
};

// Presses come before dials and pointer, and each is obeyed before the next one is read: what a press means
// depends on what the one before it did. The draft is renewed once, after everything that can change it.
const board::Snapshot& ExpressionEditor::Play(const board::Snapshot& board, performance::InputEvents& events,
                                              const show::Show& show, performance::State& state,
                                              Time presented_at) {
  const auto dt_s = static_cast<float>(std::max(0.0, Seconds(presented_at - now_)));
  now_ = presented_at;
  shown_ = performance::Travel(shown_, open_ ? 1.0F : 0.0F, std::min(dt_s, kLongestStep_s), kShow_per_s);
  renewed_.clear();
  const bool was_open = open_;
  Situation situation{show, state, presented_at};
  events.Consume([&](const performance::Press& press) { return HandlePress(press, situation); });
  for (const Command& command : input_.ReadMotion(board, events, open_, now_)) Obey(command, situation);
  if (writer_.has_outcomes()) HandleOutcomes();
  ShowDraft();
  if (!was_open && !open_) return board;
  return RemoveUsedInput(board, events);
}

// Gives whether the press was the editor's. Each is judged by what it was pressed into: a press that closes
// the editor is the editor's, and the next one is not.
bool ExpressionEditor::HandlePress(const performance::Press& press, Situation& now) {
  const bool was_open = open_, was_typing = input_.typing().has_value();
  for (const Command& command : ReadPress(press, now)) Obey(command, now);
  if (!was_open && !open_)
    return press.IsKey() && (press.code == key::kTab || (press.shift && SlotOfDigit(press.code) >= 0));
  return !PlaysOn(press, now, was_typing || input_.typing());
}

// A key is no button, and calls nothing on a sheet of them.
std::vector<Command> ExpressionEditor::ReadPress(const performance::Press& press, const Situation& now) {
  const show::Call button =
      press.IsKey() ? show::Call{} : performance::ButtonOf(now.state, now.show, press.code);
  return input_.ReadPress(press, now.show, button, open_, now_);
}

// A closed editor gets two kinds of commands only: Tab, and the call of an own expression.
void ExpressionEditor::Obey(const Command& command, Situation& now) {
  if (command.verb == Verb::kToggle) return open_ ? Leave(now) : Start(now);
  if (!open_) return CallOwn(command.index, now);
  if (!ObeyPull(command) && !ObeyChoice(command)) ObeyKeeping(command, now);
}

// Commands that pull. Gives whether this was one.
bool ExpressionEditor::ObeyPull(const Command& command) {
  const auto handle = static_cast<std::size_t>(chosen_);  // -1 is beyond all handles: nothing is pulled.
  switch (command.verb) {
    case Verb::kPull:
      Did(session_.Pull(handle, command.by_m, command.gesture));
      return true;
    case Verb::kDrag:
      Drag(command);
      return true;
    case Verb::kScale:
      Did(session_.Scale(command.amount, command.gesture));
      return true;
    case Verb::kShutLids:
      Did(session_.ShutLids(command.amount, command.gesture));
      return true;
    case Verb::kZero:
      Did(session_.Zero(handle));
      return true;
    case Verb::kUndo:
      Did(session_.Undo());
      return true;
    case Verb::kRedo:
      Did(session_.Redo());
      return true;
    default:
      return false;
  }
}

// The skin goes where the pointer goes, though it gives way to its neighbours.
void ExpressionEditor::Drag(const Command& command) {
  if (chosen_ < 0) return;
  const auto handle = static_cast<std::size_t>(chosen_);
  const float yield = std::max(session_.Yield(handle), kLeastYield);
  Did(session_.Pull(handle, picker_.PullAlong(handle, command.a) / yield, command.gesture));
}

// Commands that say what is pulled and how it spreads. Gives whether this was one.
bool ExpressionEditor::ObeyChoice(const Command& command) {
  switch (command.verb) {
    case Verb::kGo:
      if (chosen_ >= 0) Choose(picker_.Next(static_cast<std::size_t>(chosen_), command.a));
      if (chosen_ < 0) Choose(picker_.Nearest(kPictureMiddle));
      return true;
    case Verb::kPress:
      Choose(picker_.Nearest(command.a));
      return true;
    case Verb::kMirror:
      session_.spread.mirror = !session_.spread.mirror;
      return true;
    case Verb::kHelp:
      help_ = !help_;
      return true;
    case Verb::kSmooth:
      session_.spread.smooth = !session_.spread.smooth;
      return true;
    default:
      return false;
  }
}

// Commands that say where the work comes from, and where it is kept.
void ExpressionEditor::ObeyKeeping(const Command& command, Situation& now) {
  switch (command.verb) {
    case Verb::kBeginFrom:
      return BeginFrom(static_cast<std::uint16_t>(command.index), now.show);
    case Verb::kBeginFromPlay:
      return BeginFrom(in_play_, now.show);
    case Verb::kOwn:
      return BeginWith(own_.at(command.index));
    case Verb::kSave:
      return Save(false);
    case Verb::kSaveAsNew:
      return Save(true);
    case Verb::kAskName:
      return input_.AskForName(Typing::For::kName, session_.work().name);
    case Verb::kName:
      return Name(command.text);
    case Verb::kNameAndSave:
      return NameAndSave(command.text, command.index == 1);
    case Verb::kDelete:
      return Delete(now.presented_at);
    default:
      return;
  }
}

// Work that is not saved goes on; else the expression in play is begun with.
void ExpressionEditor::Start(Situation& now) {
  const std::uint16_t called = now.state.expressions.to;
  if (called != draft()) in_play_ = called;
  if (!session_.unsaved()) {
    if (const auto work = called == draft() ? std::nullopt : WorkOf(called, now.show))
      Did(session_.Begin(*work));
  } else if (called != draft()) {
    Say("unsaved work; P begins from what was in play");
  }
  open_ = true;
  CallWhole(now.state, draft(), kChange_s);
  At(now.state.knobs, Knob::kStrength) = 1;  // Pulls are seen as they are written.
  if (chosen_ < 0) Choose(picker_.Nearest(kPictureMiddle));
}

// What is saved is played from its own slot, so that the next work does not change it.
void ExpressionEditor::Leave(Situation& now) {
  open_ = false;
  const int slot = session_.work().slot;
  if (session_.unsaved()) return;
  CallWhole(now.state, slot >= 0 && own_.at(slot) ? own(slot) : in_play_, kChange_s);
}

void ExpressionEditor::CallOwn(int slot, Situation& now) {
  if (own_.at(slot)) CallWhole(now.state, own(slot), At(now.state.knobs, Knob::kFade));
}

// The one place that knows of the journal: no change can be made without its being noted.
void ExpressionEditor::Did(Change change) {
  if (change == Change::kNone) return;
  draft_outdated_ = true;
  writer_.Note(change, session_.work());
}

void ExpressionEditor::BeginWith(const std::optional<Work>& work) {
  if (!work) return Say("there is no such expression");
  Did(session_.Replace(*work));
}

void ExpressionEditor::BeginFrom(std::uint16_t expression, const show::Show& show) {
  BeginWith(WorkOf(expression, show));
  WarnOfResidual(expression, show);
}

void ExpressionEditor::WarnOfResidual(std::uint16_t expression, const show::Show& show) {
  const face::Expression& begun = show.cast.expressions[expression];
  if (!begun.residual.empty() || begun.pupil != 1) Say("what no needle can say of it is left out");
}

// Nothing for one that is no expression, or that no key calls any more.
std::optional<Work> ExpressionEditor::WorkOf(std::uint16_t index, const show::Show& show) const {
  if (index >= first_) return index < draft() ? own_.at(static_cast<int>(index - first_)) : std::nullopt;
  const face::Expression& expression = show.cast.expressions[index];
  return Work{expression.displacement, expression.lids, "", expression.name, -1};
}

void ExpressionEditor::Choose(std::optional<std::size_t> handle) {
  if (handle) chosen_ = static_cast<int>(*handle);
}

void ExpressionEditor::Say(std::string message) {
  message_ = std::move(message);
  message_until_ = now_ + kMessage;
}

// What is compared with is the work as it was begun.
void ExpressionEditor::ShowDraft() {
  if (input_.comparing() != compared_) draft_outdated_ = true;
  compared_ = input_.comparing();
  if (!draft_outdated_) return;
  draft_outdated_ = false;
  renewed_.push_back({draft(), compared_ ? &session_.before() : &session_.work()});
}

// While the editor is open buttons and keys that call faces, styles and sheets are the performance's still,
// unless a name is typed or the editor has a use for the key.
bool ExpressionEditor::PlaysOn(const performance::Press& press, const Situation& now, bool typing) {
  const auto stays = [](show::CallKind kind) {
    return kind == show::CallKind::kFace || kind == show::CallKind::kStyle || kind == show::CallKind::kSheet;
  };
  if (!press.IsKey()) return stays(performance::ButtonOf(now.state, now.show, press.code).kind);
  if (typing || IsForEditor(press.code)) return false;
  return std::ranges::any_of(now.show.keys, [&](const show::KeyCall& call) {
    return call.key_usage == press.code && stays(call.call.kind);
  });
}

// Dials, keys that are held and the right stick are the editor's while it is open.
const board::Snapshot& ExpressionEditor::RemoveUsedInput(const board::Snapshot& board,
                                                         performance::InputEvents& events) {
  for (const std::size_t dial : kEditorDials) events.turned[dial] = 0;
  events.pointer = {};
  rest_ = board;
  rest_.keys.value.down = {};
  board::Stick& stick = rest_.sticks[1].value;
  stick.x = stick.y = stick.twist = stick.slider = 0;
  stick.hat = -1;
  return rest_;
}

// The handles' pulls are lengths: how far each is pulled, and not where to.
void ExpressionEditor::Describe(scene::Scene& scene) const {
  if (!(shown_ > 0)) return;
  const float shown = performance::SmoothStep(shown_);
  const Work& work = compared_ ? session_.before() : session_.work();
  scene.handles.shown = shown;
  scene.handles.chosen = chosen_;
  if (chosen_ >= 0 && session_.spread.mirror)
    scene.handles.partner = session_.points().partners[static_cast<std::size_t>(chosen_)];
  for (const glm::vec3& pull_m : work.pulls_m) scene.handles.pulls_m.push_back(glm::length(pull_m));
  scene.caption.shown = shown;
  scene.caption.lines = CaptionLines({.session = session_,
                                      .chosen = chosen_,
                                      .typing = input_.typing(),
                                      .comparing = compared_,
                                      .help = help_,
                                      .own = own_.Contents(),
                                      .message = now_ < message_until_ ? message_ : "",
                                      .trouble = trouble_});
}

void ExpressionEditor::Look(const face::Cast& cast, const face::Shape& shape, const scene::Scene& scene,
                            float aspect) {
  picker_.Look(cast, shape, scene, aspect);
}

}  // namespace kaori::editor
