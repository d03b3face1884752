// The expression editor: an author makes an expression on the box, while the show plays. For people its
// handles, which stand on the face, are called needles. It stands between board and performance: stage.cpp
// hands it the frame's events first, and what it uses the performance does not see. docs/needles.play and the
// guide say how it is used.
//
//   input.h            what the author's presses and movements ask for
//   session.h          the work: pulls of control points, and the way back
//   history.h          its steps
//   handle_picker.h    where the handles stand in the picture
//   caption.h          what is written beside the face
//   own.h, store.h     the box's own expressions as texts and files
//   record.h, journal.h, work_writer.h   every change on the disk, so that a crash loses next to nothing
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"
#include "appliance/programs/editor/handle_picker.h"
#include "appliance/programs/editor/input.h"
#include "appliance/programs/editor/own_expressions.h"
#include "appliance/programs/editor/session.h"
#include "appliance/programs/editor/work_writer.h"
#include "render/scene/scene.h"

namespace kaori::editor {

// One thread, that of the stage; the disk is left to another one. A frame goes through it in this order:
// Play, renewed(), the performance, Describe, drawing, Look.
class ExpressionEditor {
 public:
  // Appends the box's own expressions, and the one in work, to the show's cast: kSlots + 1 of them, empty or
  // not, so that their number never changes. Takes up the work that an earlier session left in the journal.
  // Logs what was found and what could not be read; without its folder the editor works in memory. Blocks for
  // the disk.
  static std::unique_ptr<ExpressionEditor> Open(const std::filesystem::path& folder, show::Show& show);
  ~ExpressionEditor();

  // Does what the author asks for by `events`, takes out of them what was the editor's, and gives what is
  // left of the board for the performance: while the editor is open, controls that pull do not play. What it
  // gives holds until the next call. `show` is the one that Open saw. Allocates only where something was
  // pressed or moved, or while the editor is open.
  const board::Snapshot& Play(const board::Snapshot& board, performance::InputEvents& events,
                              const show::Show& show, performance::State& state, Time presented_at);

  // Writes what the frame shows of the editor: its handles and its caption.
  void Describe(scene::Scene& scene) const;

  // To be called after each frame with the face as it was drawn: what the author sees and points at. `aspect`
  // is the picture's width over its height.
  void Look(const face::Cast& cast, const face::Shape& shape, const scene::Scene& scene, float aspect);

  // Expressions of the cast that Play has made anew, each with what it is now. Cleared by the next Play.
  struct Renewed {
    std::uint16_t index = 0;
    const Work* work = nullptr;
  };
  // `work` is borrowed from the editor and holds until the next Play.
  const std::vector<Renewed>& renewed() const { return renewed_; }

  // Whether the author is at work; while it is false nothing but Tab and the keys of own expressions is the
  // editor's.
  bool open() const { return open_; }
  // Shuts it at once. The work stays as it is, and what is called in the show too.
  void Close() { open_ = false; }
  // The author's work, for tests and for what is drawn.
  const Session& session() const { return session_; }
  // The control point that is pulled; -1: none.
  int chosen() const { return chosen_; }
  std::uint16_t draft() const {
    return static_cast<std::uint16_t>(first_ + kSlots);
  }  // The work's expression.
  // The cast's index of an own expression, 0 .. kSlots - 1.
  std::uint16_t own(int slot) const { return static_cast<std::uint16_t>(first_ + slot); }

  // Waits until all that was asked for was written, or was refused. For tests and an orderly end.
  void Finish() { writer_.Finish(); }

 private:
  struct Kept;  // What an earlier session left on the disk.
  // `show_names` are those of the show's own expressions, before any were appended.
  ExpressionEditor(Kept kept, const face::Cast& cast, std::vector<std::string> show_names);

  struct Situation;
  // Does one command. ObeyPull, ObeyChoice and ObeyKeeping have one kind of commands each; the first two say
  // whether it was theirs.
  void Obey(const Command& command, Situation& now);
  bool ObeyPull(const Command& command);
  // Pulls the chosen handle along with the pointer.
  void Drag(const Command& command);
  bool ObeyChoice(const Command& command);
  void ObeyKeeping(const Command& command, Situation& now);
  // Opens the editor on what is in play, and closes it again, with the expression that is then called.
  void Start(Situation& now);
  void Leave(Situation& now);
  // Calls an own expression in the show; nothing where the slot is empty.
  void CallOwn(int slot, Situation& now);
  // To be told of every change of the session: the draft is renewed, and the journal notes it.
  void Did(Change change);
  // Takes up other work: a given one, or that of an expression of the cast.
  void BeginWith(const std::optional<Work>& work);
  void BeginFrom(std::uint16_t expression, const show::Show& show);
  // Says where an expression has a part that control points cannot hold, and that is lost by editing it.
  void WarnOfResidual(std::uint16_t expression, const show::Show& show);
  // The expression of the cast as work without a name; of an own one the work itself, and nothing for an
  // empty slot.
  std::optional<Work> WorkOf(std::uint16_t expression, const show::Show& show) const;
  // editor_saving.cpp: names, slots and files.
  void Save(bool as_new);
  void NameAndSave(const std::string& name, bool as_new);
  void Name(const std::string& name);
  void Delete(Time now);
  // Chooses a handle; nothing leaves the choice as it is.
  void Choose(std::optional<std::size_t> handle);
  // Shows a message for four seconds; it replaces the one before.
  void Say(std::string message);
  void HandleOutcomes();
  // Renews the cast's draft where the work, or what of it is shown, has changed.
  void ShowDraft();
  // Whether the press was the editor's: then it does not play.
  bool HandlePress(const performance::Press& press, Situation& now);
  // Whether a press still plays while the editor is open.
  static bool PlaysOn(const performance::Press& press, const Situation& now, bool typing);
  // What the press asks the editor for.
  std::vector<Command> ReadPress(const performance::Press& press, const Situation& now);
  // Takes dials, pointer, held keys and the right stick out of what the performance sees.
  const board::Snapshot& RemoveUsedInput(const board::Snapshot& board, performance::InputEvents& events);

  std::size_t first_;  // Index of the first own expression in the cast.
  Session session_;
  OwnExpressions own_;
  HandlePicker picker_;
  EditorInput input_;
  bool open_ = false;
  // How much of handles and caption is there, 0 .. 1 before smoothing.
  float shown_ = 0;
  // -1: none; the constructor chooses nothing.
  int chosen_ = -1;
  // The expression that was in play before the editor was opened.
  std::uint16_t in_play_ = 0;
  // The work is shown as it was before, while C is held.
  bool compared_ = false;
  bool help_ = true;
  // The work has changed since the cast's draft was renewed.
  bool draft_outdated_ = false;
  Time now_{};
  std::string message_;
  Time message_until_{};
  // Until then a second Delete deletes.
  Time delete_until_{};
  // Why nothing is written to the disk; empty where it is.
  std::string trouble_;
  // Of this frame; see renewed().
  std::vector<Renewed> renewed_;
  // The board without what the editor uses; Play gives it.
  board::Snapshot rest_;
  // Last: it waits for the disk when the editor goes.
  WorkWriter writer_;
};

// Where a box keeps its own expressions: /var/lib/kaori/own where that folder exists, else in the home of
// whoever plays ($XDG_STATE_HOME/kaori/own). Empty: nowhere.
std::filesystem::path UsualFolder();

}  // namespace kaori::editor
