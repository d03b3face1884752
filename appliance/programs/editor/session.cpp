#include "appliance/programs/editor/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace kaori::editor {
namespace {

constexpr float kFarthest_m = 0.05F;  // No handle is pulled further: what is beyond is no face.
constexpr float kReach_m = 0.012F;    // Of a smooth pull: half a cheek.
// Handles that would follow by less are left alone: a file names every handle that moves.
constexpr float kLeastShare = 0.02F;
constexpr glm::vec3 kMirrored{-1, 1, 1};

// How much a handle at this distance follows a pull, 1 at the pulled one: a bell curve of standard deviation
// kReach_m, or nothing but the handle itself.
float ShareAt(float apart_m, bool smooth) {
  if (!smooth) return apart_m > 0 ? 0.0F : 1.0F;
  const float share = std::exp(-apart_m * apart_m / (2 * kReach_m * kReach_m));
  return share < kLeastShare ? 0.0F : share;
}

// What a pull of `point` does to one handle of the face. A mirrored pull moves the middle nowhere sideways. A
// handle follows the nearer one of the pulled point and its partner; on the partner's side u is mirrored.
// Handles in the middle, or equally far from both, get no sideways part, since the two pulls cancel there.
glm::vec3 PullOn(const Points& points, std::size_t handle, std::size_t point, glm::vec3 by_m, Spread spread) {
  const float apart_m = points.Apart_m(handle, point);
  if (!spread.mirror) return by_m * ShareAt(apart_m, spread.smooth);
  const int partner = points.partners[point];
  const float mirrored_m = partner < 0 ? apart_m : points.Apart_m(handle, static_cast<std::size_t>(partner));
  const bool middle = partner < 0 || points.partners[handle] < 0 || mirrored_m == apart_m;
  const glm::vec3 way = middle ? glm::vec3(0, 1, 1) : mirrored_m < apart_m ? kMirrored : glm::vec3(1);
  return by_m * way * ShareAt(std::min(apart_m, mirrored_m), spread.smooth);
}

// Each axis by itself.
glm::vec3 Bounded(glm::vec3 pull_m) {
  return glm::clamp(pull_m, -kFarthest_m, kFarthest_m);
}

bool Finite(glm::vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

// There is always work: at first a blank one, which counts as saved.
Session::Session(Points points) : points_(std::move(points)) {
  Begin({.pulls_m = std::vector<glm::vec3>(points_.size())});
}

// A journal that is replayed comes here too, and after it whatever else the session did.
Change Session::Begin(Work work) {
  if (!Fits(work)) return Change::kNone;
  saved_ = work;
  history_.Begin(std::move(work));
  gesture_ = 0;
  return Change::kBegun;
}

// The step is fresh, so that comparing shows the adopted work and not what was there before it.
Change Session::Replace(Work work) {
  if (!Fits(work)) return Change::kNone;
  history_.Push(std::move(work), true);
  gesture_ = 0;
  return Change::kAdopted;
}

// The bound is for each axis of each handle, so that a pull at the end of the range still moves the others.
Change Session::Pull(std::size_t point, glm::vec3 by_m, Gesture gesture) {
  if (point >= points_.size() || !Finite(by_m)) return Change::kNone;
  Work work = history_.now();
  for (std::size_t i = 0; i < work.pulls_m.size(); ++i)
    work.pulls_m[i] = Bounded(work.pulls_m[i] + PullOn(points_, i, point, by_m, spread));
  return Step(std::move(work), gesture);
}

// A step of its own, never part of a gesture.
Change Session::Zero(std::size_t point) {
  if (point >= points_.size()) return Change::kNone;
  Work work = history_.now();
  work.pulls_m[point] = {};
  const int partner = points_.partners[point];
  if (spread.mirror && partner >= 0) work.pulls_m[static_cast<std::size_t>(partner)] = {};
  return Step(std::move(work), 0);
}

// A pull at the bound stays there, so that turning back does not bring back its exact size.
Change Session::Scale(float factor, Gesture gesture) {
  if (!std::isfinite(factor)) return Change::kNone;
  Work work = history_.now();
  for (glm::vec3& pull_m : work.pulls_m) pull_m = Bounded(pull_m * factor);
  return Step(std::move(work), gesture);
}

// Both lids go by as much, and the one that is at its end waits for the other.
Change Session::ShutLids(float by, Gesture gesture) {
  if (!std::isfinite(by)) return Change::kNone;
  Work work = history_.now();
  for (float& lid : work.lids) lid = std::clamp(lid + by, 0.0F, 1.0F);
  return Step(std::move(work), gesture);
}

// A pull that follows begins a new step, even where the control is still moving; Redo does the same.
Change Session::Undo() {
  gesture_ = 0;
  return history_.Undo() ? Change::kUndone : Change::kNone;
}

Change Session::Redo() {
  gesture_ = 0;
  return history_.Redo() ? Change::kRedone : Change::kNone;
}

// Gives kRenamed even where nothing changed: it is a decision, and the journal keeps it.
Change Session::Rename(std::string name, int slot) {
  Work like = history_.now();
  like.name = std::move(name);
  like.slot = slot;
  history_.Rename(like);
  return Change::kRenamed;
}

// What the author does next is a new step, though the dial may still be turning.
Change Session::Keep(const Work& saved) {
  saved_ = saved;
  gesture_ = 0;
  return Change::kKept;
}

// A step that changes nothing is none: a dial at its end, a handle that is zero already. A gesture goes on in
// the newest step only: after an undo it begins another one.
Change Session::Step(Work work, Gesture gesture) {
  if (work == history_.now()) return Change::kNone;
  const bool goes_on = gesture != 0 && gesture == gesture_ && history_.redoable() == 0;
  gesture_ = gesture;
  if (goes_on) {
    history_.Replace(std::move(work));
    return Change::kReplaced;
  }
  history_.Push(std::move(work));
  return Change::kPushed;
}

// The order of the journal brings the history back; the pulls themselves are not worked out again, so that a
// later version of the program finds the same work.
void Session::Replay(Change change, const Work& work) {
  gesture_ = 0;
  if (change == Change::kUndone) Undo();
  if (change == Change::kRedone) Redo();
  if (!Fits(work)) return;
  if (change == Change::kBegun) Begin(work);
  if (change == Change::kAdopted) Replace(work);
  if (change == Change::kPushed) history_.Push(work);
  if (change == Change::kReplaced) history_.Replace(work);
  if (change == Change::kRenamed) Rename(work.name, work.slot);
  if (change == Change::kKept) Keep(work);
}

// The skin at a point follows all handles around it, so that a pull spread over them moves it further than
// one handle alone.
float Session::Yield(std::size_t point) const {
  float yield = 0;
  for (std::size_t i = 0; i < points_.size(); ++i)
    yield += points_.Follows(point, i) * ShareAt(points_.Apart_m(i, point), spread.smooth);
  return yield;
}

// Whether the work can be of these control points: their number, finite pulls, lids within 0..1, a slot that
// exists.
bool Session::Fits(const Work& work) const {
  const auto within = [](float lid) { return lid >= 0 && lid <= 1; };
  return work.pulls_m.size() == points_.size() && std::ranges::all_of(work.pulls_m, Finite) &&
         std::ranges::all_of(work.lids, within) && work.slot >= -1 && work.slot < kSlots;
}

}  // namespace kaori::editor
