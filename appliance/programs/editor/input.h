// The author's input: what dials, right stick, buttons, keys and pointer ask for while the editor is open.
//
//   dials 2 3 4        pull along u, v and outwards: a centimetre a turn
//   dials 5 6          scale all pulls; shut the lids
//   right stick        goes to the next handle in its direction
//   pointer, wheel     chooses and drags; pulls outwards
//   buttons, keys      that call expressions begin from them
//   arrows             choose; the letters are in the caption (caption.cpp)
//
// Dials count from 1 as they are labelled, and from 0 in kEditorDials.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/show/show.h"
#include "appliance/programs/editor/session.h"

namespace kaori::editor {

// What a command asks for. Fields of Command are named where a verb has any.
enum class Verb : std::uint8_t {
  kToggle,    // Opens or closes the editor.
  kGo,        // Chooses the next handle in direction `a`, right and up.
  kPress,     // Chooses the handle at position `a` of the picture, 0..1 from the left top.
  kDrag,      // Pulls the chosen one through the picture by `a`, right and down.
  kPull,      // Pulls the chosen one by `by_m`.
  kScale,     // All pulls by factor `amount`.
  kShutLids,  // By `amount`.
  kMirror,    // On or off.
  kSmooth,    // On or off.
  kHelp,      // All keys in the caption, or few.
  kZero,      // The chosen one.
  kUndo,
  kRedo,
  kBeginFrom,      // Begins from the expression `index` of the cast.
  kBeginFromPlay,  // The same of the one that was in play before the editor was opened.
  kOwn,            // Begins from the own expression of slot `index`; where the editor is closed, calls it.
  kSave,
  kSaveAsNew,
  kAskName,      // Wants to name the work.
  kName,         // The work is named `text`.
  kNameAndSave,  // As new where `index` is 1.
  kDelete,
};

// What the author wants, in the editor's own terms. Fields that the verb does not name are unused. Commands
// are obeyed in the order in which they were read, each before the next press is read.
struct Command {
  Verb verb = Verb::kToggle;
  // Into the cast's expressions, or a slot; what else it is stands at the verb.
  int index = 0;
  float amount = 0;
  // A position or a direction of the picture, as the verb says.
  glm::vec2 a{};
  // Along u, v and outwards.
  glm::vec3 by_m{};
  Gesture gesture = 0;
  std::string text{};
};

// A name that is being typed.
struct Typing {
  enum class For : std::uint8_t { kName, kSave, kSaveAsNew } purpose{};
  std::string text;
};

// Which dials are the editor's while it is open, and not the performance's: u, v, outwards, scale, lids.
inline constexpr std::array<std::size_t, 5> kEditorDials{1, 2, 3, 4, 5};

// One thread. Allocates only where something was pressed or moved. It remembers what input means over time: a
// name that is typed, a gesture, a stick that is held, a drag. It moves nothing itself.
class EditorInput {
 public:
  // What one press asks for. Presses come one by one, each after what the one before it asked for was done: a
  // name may be asked for, typed and kept within one frame. While the editor is closed only Tab and Shift
  // with a digit mean something.
  // `button` is what the button calls on its sheet; of no account for a key.
  std::vector<Command> ReadPress(const performance::Press& press, const show::Show& show,
                                 const show::Call& button, bool open, Time now);

  // What dials, right stick and pointer ask for, after the presses of the frame. What the editor uses of
  // `events` stays in them.
  std::vector<Command> ReadMotion(const board::Snapshot& board, const performance::InputEvents& events,
                                  bool open, Time now);

  // The name is asked for; keys type until Enter or Escape.
  void AskForName(Typing::For purpose, std::string text);

  const std::optional<Typing>& typing() const { return typing_; }
  bool comparing() const { return comparing_; }  // C is held.

 private:
  // What one call looks at, with the commands that it has found so far.
  struct Reading;
  // Each adds the commands that its device asks for: a key, a key of a name that is typed, the dials, the
  // right stick, the pointer.
  void ReadKey(Reading& reading, const performance::Press& press);
  void Type(Reading& reading, const performance::Press& press);
  void ReadDials(Reading& reading, const performance::InputEvents& events, std::int32_t counts_per_turn);
  void ReadStick(Reading& reading, const board::Stamped<board::Stick>& stick);
  void ReadPointer(Reading& reading, const performance::InputEvents::Pointer& moved,
                   const board::Pointer& held);
  // Chooses the next handle in a direction of the picture.
  void Go(Reading& reading, glm::vec2 direction);
  // The number of the gesture to which a movement of this control belongs now; a long rest begins another
  // one.
  Gesture GestureOf(int kind, Time now);
  void EndGesture() { gesture_kind_ = -1; }

  std::optional<Typing> typing_;
  bool comparing_ = false;
  // The number, the control and the last movement of the newest gesture; numbers begin with 1.
  Gesture last_gesture_ = 0;
  int gesture_kind_ = -1;
  Time gesture_at_{};
  std::optional<Time> next_step_;  // Of a stick that is held.
  // The left button was pressed while the editor was open, and is still down.
  bool dragging_ = false;
};

}  // namespace kaori::editor
