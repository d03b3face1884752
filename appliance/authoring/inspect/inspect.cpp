#include "appliance/authoring/inspect/inspect.h"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "appliance/authoring/inspect/folds.h"
#include "appliance/authoring/inspect/lid_gaps.h"
#include "appliance/authoring/inspect/poses.h"
#include "appliance/authoring/inspect/skin.h"
#include "appliance/authoring/inspect/teeth.h"
#include "render/face/composer.h"
#include "render/face/jaw.h"

namespace kaori::inspect {
namespace {

constexpr float kSquareMillimetre_m2 = 1e-6F;
constexpr float kMillimetre_m = 1e-3F;

// Triangles of the fine mesh that expressions or lids can move: those with a vertex that depends on a moving
// one of the cage.
std::vector<bool> FindMoving(const face::Topology& topology) {
  const face::SparseRows& rows = topology.fine.from_cage;
  const auto moves = [&](face::Index vertex) {
    const auto first = rows.column.begin() + rows.row_start[vertex];
    const auto last = rows.column.begin() + rows.row_start[vertex + 1];
    return std::any_of(first, last, [&](face::Index v) { return v < topology.moving_count; });
  };
  std::vector<bool> moving;
  moving.reserve(topology.fine.triangles.size());
  for (const face::Triangle& t : topology.fine.triangles) moving.push_back(std::ranges::any_of(t, moves));
  return moving;
}

// One thread's: composer, poses, and the skin of the face in work. Made once, used for face after face.
// Borrows the cast.
class Inspector {
 public:
  Inspector(const face::Cast& cast, Scope scope)
      : cast_(cast),
        scope_(scope),
        composer_(cast),
        moving_(FindMoving(cast.topology)),
        poses_(PosesToSee(cast.expressions)) {
    // The quick look of an author at work: lids stay open, and nothing is combined.
    if (scope == Scope::kFoldsAlone) std::erase_if(poses_, [](const Pose& p) { return p.shut || !p.alone; });
    // As the stage limits it (performance): a jaw that is opened by two things at once.
    for (Pose& pose : poses_) face::LimitJaw(cast, pose.weights);
  }

  // Poses are kept, and only their face is exchanged.
  Inspection InspectFace(std::uint16_t face) {
    found_ = {};
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      Pose& pose = poses_[i];
      pose.weights.faces.clear();
      pose.weights.faces.Push(face, 1);
      const auto& shape = composer_.Compose(pose.weights, face::Detail::kFine);
      if (i == 0) LookForSkin(shape);
      SeekFolds(shape, i == 0, face, pose.name);
      if (scope_ == Scope::kFoldsAlone) continue;
      if (pose.shut) {
        // Shut lids alone are what the audience sees most, and are looked at from nine sides.
        SeekLidGaps(shape, pose.alone ? Sides::kNine : Sides::kThree, face, pose.name);
      } else {
        SeekTeeth(shape, face, pose.name);
      }
    }
    return std::move(found_);
  }

 private:
  const face::FineMesh& mesh() const { return cast_.topology.fine; }

  // From the first pose, which is the face at rest.
  void LookForSkin(const face::Shape& at_rest) {
    skin_ = FindSkin(at_rest, mesh().triangles);
    moving_skin_ = skin_;
    for (std::size_t i = 0; i < skin_.size(); ++i) moving_skin_[i] = skin_[i] && moving_[i];
  }

  // With names instead of numbers: findings are read without the cast.
  void Add(std::uint16_t face, const std::string& pose, Finding finding) {
    finding.face = cast_.faces[face].name;
    finding.pose = pose;
    found_.findings.push_back(std::move(finding));
  }

  void SeekFolds(const face::Shape& shape, bool at_rest, std::uint16_t face, const std::string& pose) {
    // At rest all of the skin is looked at; later what cannot move has been seen.
    const Folds folds = FindFolds(shape.fine, mesh(), at_rest ? skin_ : moving_skin_);
    const auto count = static_cast<int>(folds.triangles.size());
    if (count == 0) return;
    // What is folded at rest is so in every pose, and is told once.
    if (at_rest)
      for (const std::size_t triangle : folds.triangles) moving_skin_[triangle] = false;
    found_.folds += count;
    Add(face, pose,
        {.flaw = Flaw::kFold, .count = count, .measure = static_cast<float>(count), .at = folds.at});
  }

  // Counted once for a pose, however many teeth stand out; how far the farthest does is the measure.
  void SeekTeeth(const face::Shape& shape, std::uint16_t face, const std::string& pose) {
    const auto through = FindTeethThroughLips(cast_, cast_.faces[face], shape, moving_skin_);
    if (through.vertices == 0) return;
    ++found_.teeth_through_lips;
    Add(face, pose,
        {.flaw = Flaw::kTeethThroughLips,
         .count = through.vertices,
         .measure = through.farthest_m / kMillimetre_m});
  }

  // Counted by eyes; measure and place are those of the worse one.
  void SeekLidGaps(const face::Shape& shape, Sides sides, std::uint16_t face, const std::string& pose) {
    const auto seen_m2 = BallsSeen_m2(shape, mesh().triangles, sides);
    const int eyes = (seen_m2[0] > 0 ? 1 : 0) + (seen_m2[1] > 0 ? 1 : 0);
    if (eyes == 0) return;
    found_.lid_gaps += eyes;
    const std::size_t worse = seen_m2[1] > seen_m2[0] ? 1 : 0;
    Add(face, pose,
        {.flaw = Flaw::kLidGap,
         .count = eyes,
         .measure = seen_m2[worse] / kSquareMillimetre_m2,
         .at = shape.eyes[worse].centre});
  }

  const face::Cast& cast_;
  Scope scope_;
  face::Composer composer_;
  std::vector<bool> moving_;
  std::vector<Pose> poses_;
  std::vector<bool> skin_, moving_skin_;  // Of the face in work.
  Inspection found_;
};

// In the order of the faces, whichever thread looked at them.
Inspection Sum(std::vector<Inspection> parts) {
  Inspection sum;
  for (Inspection& part : parts) {
    sum.folds += part.folds;
    sum.lid_gaps += part.lid_gaps;
    sum.teeth_through_lips += part.teeth_through_lips;
    std::ranges::move(part.findings, std::back_inserter(sum.findings));
  }
  return sum;
}

}  // namespace

// Workers share only the number of the next face and its lock: each result has a place of its
// own, and nothing is locked while a face is looked at.
Inspection Inspect(const face::Cast& cast, const std::function<void(const std::string&)>& face_begun,
                   Scope scope) {
  if (cast.topology.fine.triangles.empty()) return {};
  std::vector<Inspection> found(cast.faces.size());
  // Faces are handed out one by one, since they take unequally long, and told of as they are: in their order.
  std::size_t next = 0;
  std::mutex handing_out;
  const auto begin_next = [&]() -> std::optional<std::size_t> {
    const std::lock_guard alone(handing_out);
    if (next == found.size()) return std::nullopt;
    face_begun(cast.faces[next].name);
    return next++;
  };
  const auto work = [&] {
    Inspector inspector(cast, scope);
    while (const auto face = begin_next())
      found[*face] = inspector.InspectFace(static_cast<std::uint16_t>(*face));
  };
  // Where the number of processors is not known, it is 0.
  const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::jthread> workers(std::min(found.size(), processors));
  for (std::jthread& worker : workers) worker = std::jthread(work);
  workers.clear();  // Each has finished.
  return Sum(std::move(found));
}

// Millimetres in the head's frame.
std::string Say(const Finding& f) {
  std::string who = f.face + ", " + f.pose;
  switch (f.flaw) {
    case Flaw::kFold:
      return fmt::format("{}: {} folded triangles, the first at {:.0f} {:.0f} {:.0f} mm", who, f.count,
                         f.at.x / kMillimetre_m, f.at.y / kMillimetre_m, f.at.z / kMillimetre_m);
    case Flaw::kLidGap:
      return fmt::format("{}: {} of the shut eyes {} {:.2f} mm2 of the ball", who, f.count,
                         f.count == 1 ? "shows" : "show", f.measure);
    case Flaw::kTeethThroughLips:
      return fmt::format("{}: teeth through lips by {:.2f} mm", who, f.measure);
  }
  return who;
}

}  // namespace kaori::inspect
