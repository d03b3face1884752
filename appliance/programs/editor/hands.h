// The author's hands: what dials, right stick, keys and pointer ask for while the needles are open.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "appliance/core/board/snapshot.h"
#include "appliance/programs/editor/session.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::editor {

enum class Verb : std::uint8_t {
  kToggle,    // Opens or closes the needles.
  kGo,        // Chooses the next needle in direction `a`, right and up.
  kPress,     // Chooses the needle at place `a` of the picture, 0..1 from the left top.
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
  kTake,        // Takes the expression `index` of the cast into work.
  kTakeInPlay,  // The one that was in play before the needles were opened.
  kPlace,       // Takes the own expression of place `index` into work; where the needles are shut, calls it.
  kSave,
  kSaveAsNew,
  kAskName,      // Wants to name the work.
  kName,         // The work is named `text`.
  kNameAndSave,  // As new where `index` is 1.
  kDelete,
};

struct Command {
  Verb verb = Verb::kToggle;
  int index = 0;
  float amount = 0;
  glm::vec2 a{};
  glm::vec3 by_m{};
  Gesture gesture = 0;
  std::string text{};
};

// A name that is being typed.
struct Typing {
  enum class For : std::uint8_t { kName, kSave, kSaveAsNew } purpose{};
  std::string text;
};

// Which hands the needles take off the performance while they are open.
inline constexpr std::array<std::size_t, 5> kTakenDials{1, 2, 3, 4, 5};  // u, v, outwards, scale, lids.

class Hands {
 public:
  // What happened since the frame before, as `seen` tells, which is the performance's. With the needles shut
  // only Tab and Shift with a digit mean something. Allocates only where a hand moved.
  std::vector<Command> Read(const board::Snapshot& board, const performance::Seen& seen,
                            const show::Show& show, bool open, Time now);

  // The name is asked for; keys type until Enter or Escape.
  void AskForName(Typing::For purpose, std::string text);

  const std::optional<Typing>& typing() const { return typing_; }
  bool comparing() const { return comparing_; }  // The hand holds C.

 private:
  struct Reading;
  void ReadKeys(Reading& reading);
  void ReadKey(Reading& reading, std::uint8_t usage);
  static void ReadKeyCall(Reading& reading, std::uint8_t usage);
  void Type(Reading& reading, std::uint8_t usage);
  void ReadDials(Reading& reading);
  void ReadButtons(Reading& reading);
  void ReadStick(Reading& reading);
  void ReadPointer(Reading& reading);
  Gesture GestureOf(int kind, Time now);
  void EndGesture() { gesture_kind_ = -1; }

  std::optional<Typing> typing_;
  bool comparing_ = false;
  Gesture last_gesture_ = 0;
  int gesture_kind_ = -1;
  Time gesture_at_{};
  std::optional<Time> next_step_;          // Of a stick that is held.
  std::optional<board::Pointer> pointer_;  // As it was seen last.
  bool dragging_ = false;
};

}  // namespace kaori::editor
