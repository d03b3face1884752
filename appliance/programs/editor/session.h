// One author at work on one expression: what the author does to it, and the way back. The editor turns input
// into these commands; the journal keeps the changes that they gave.
#pragma once

#include <cstdint>
#include <string>

#include "appliance/programs/editor/history.h"
#include "appliance/programs/editor/points.h"
#include "appliance/programs/editor/work.h"

namespace kaori::editor {

// What a command did to the history. In this order and with the work they led to, changes make the same
// session again: see Session::Replay.
enum class Change : std::uint8_t {
  kNone,
  kBegun,     // All before is forgotten.
  kAdopted,   // A step: the work is a copy of another expression.
  kPushed,    // A step.
  kReplaced,  // The newest step went on.
  kUndone,
  kRedone,
  kRenamed,  // The work has another name or slot.
  kKept,     // The work was saved.
};
inline constexpr Change kLastChange = Change::kKept;

// Movements of one gesture (a drag, a turn of a dial) are one step. 0 is no gesture: a step of its own.
using Gesture = std::uint32_t;

// How pulls spread.
struct Spread {
  bool mirror = true;   // To the same handle of the other side.
  bool smooth = false;  // To the neighbours, the nearer the more.
};

// No device, no file, no clock; one thread. Every command gives what it changed, and kNone where that is
// nothing: an index that no control point has, a number that is not finite, a dial at its end. No pull goes
// further than 5 cm.
class Session {
 public:
  // Begins with blank work that counts as saved.
  explicit Session(Points points);

  // Begins with `work` as saved; nothing can be undone. Gives kBegun, or kNone where the work does not fit.
  Change Begin(Work work);
  // Puts other work in its place as a step that can be undone: kAdopted. It counts as unsaved where it
  // differs from what was saved.
  Change Replace(Work work);
  // Pulls a control point by u, v and outwards of its own frame on the face; others follow as `spread` says.
  // `by_m` is added to the pulls there are. Gives kPushed, or kReplaced where a gesture goes on.
  Change Pull(std::size_t point, glm::vec3 by_m, Gesture gesture = 0);
  Change Zero(std::size_t point);  // And its partner, where pulls are mirrored.
  // All pulls by a factor; lids stay.
  Change Scale(float factor, Gesture gesture = 0);
  // Both lids by this much, each within 0 open .. 1 shut.
  Change ShutLids(float by, Gesture gesture = 0);
  // One step back, one forth: kUndone, kRedone.
  Change Undo();
  Change Redo();
  // Of all steps since the work was begun: going back does not bring an old name back. The caller
  // has checked both (OwnExpressions::ReasonAgainst).
  Change Rename(std::string name, int slot);
  // `saved` is on the disk: the work is unsaved from here on where it differs.
  Change Keep(const Work& saved);

  // A change of an earlier session. Where `work` does not fit the control points, nothing happens.
  void Replay(Change change, const Work& work);

  // How far the skin at the point goes with a pull of its handle, as pulls spread now: 1 is as far.
  float Yield(std::size_t point) const;

  // The work, and as it was when it was begun; each holds until the next command.
  const Work& work() const { return history_.now(); }
  const Work& before() const { return history_.before(); }
  // Whether the work differs from what was saved or begun with.
  bool unsaved() const { return !(work() == saved_); }
  // How many steps lie before the work, and behind it.
  std::size_t undoable() const { return history_.undoable(); }
  std::size_t redoable() const { return history_.redoable(); }
  // The control points, as of the cast that the session was made for.
  const Points& points() const { return points_; }

  // How pulls spread from now on; the author's switches, which are no part of the work.
  Spread spread;

 private:
  // Makes `work` the newest step, or lets the newest one go on where it is of the same gesture.
  Change Step(Work work, Gesture gesture);
  // Whether the work can be of these control points; other work is refused.
  bool Fits(const Work& work) const;

  Points points_;
  History history_;
  // What is on the disk, or what was begun with.
  Work saved_;
  Gesture gesture_ = 0;  // Of the newest step; 0 when it is closed.
};

}  // namespace kaori::editor
