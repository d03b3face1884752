#include "appliance/atelier/inspect/inspect.h"

#include <utility>

#include <fmt/format.h>

#include "appliance/atelier/inspect/folds.h"
#include "appliance/atelier/inspect/lid_gaps.h"
#include "appliance/atelier/inspect/skin.h"
#include "appliance/atelier/inspect/teeth.h"
#include "render/face/composer.h"

namespace kaori::inspect {
namespace {

constexpr float kSquareMillimetre_m2 = 1e-6F;
constexpr float kMillimetre_m = 1e-3F;

// The expression alone, as an operator calls it up: mouth shapes and channels on the face at rest.
face::Weights Wearing(const face::Cast& cast, std::uint16_t face, std::uint16_t expression, float lids_shut) {
  face::Weights weights;
  weights.faces.Push(face, 1);
  const bool called = cast.expressions[expression].kind == face::ExpressionKind::kExpression;
  weights.expressions.Push(called ? expression : 0, 1);
  if (!called) weights.channels.Push(expression, 1);
  weights.lids_shut = {lids_shut, lids_shut};
  return weights;
}

class Inspector {
 public:
  explicit Inspector(const face::Cast& cast) : cast_(cast), composer_(cast) {}

  void InspectFace(std::uint16_t face) {
    const auto& at_rest = composer_.Compose(Wearing(cast_, face, 0, 0), face::Detail::kFine);
    skin_ = FindSkin(at_rest, mesh().triangles);
    const auto expressions = static_cast<std::uint16_t>(cast_.expressions.size());
    for (std::uint16_t e = 0; e < expressions; ++e) {
      const auto& open = composer_.Compose(Wearing(cast_, face, e, 0), face::Detail::kFine);
      SeekFolds(open, face, cast_.expressions[e].name);
      SeekTeeth(open, face, cast_.expressions[e].name);
      const auto& shut = composer_.Compose(Wearing(cast_, face, e, 1), face::Detail::kFine);
      SeekLidGaps(shut, face, cast_.expressions[e].name);
      if (e == 0) SeekFolds(shut, face, "lids shut");
    }
  }

  Inspection Take() { return std::move(found_); }

 private:
  const face::FineMesh& mesh() const { return cast_.topology.fine; }

  void Add(std::uint16_t face, const std::string& expression, Finding finding) {
    finding.face = cast_.faces[face].name;
    finding.expression = expression;
    found_.findings.push_back(std::move(finding));
  }

  void SeekFolds(const face::Shape& shape, std::uint16_t face, const std::string& expression) {
    const Folds folds = FindFolds(shape.fine, mesh(), skin_);
    const auto count = static_cast<int>(folds.triangles.size());
    if (count == 0) return;
    found_.folds += count;
    Add(face, expression,
        {.flaw = Flaw::kFold, .count = count, .measure = static_cast<float>(count), .at = folds.at});
  }

  void SeekTeeth(const face::Shape& shape, std::uint16_t face, const std::string& expression) {
    const auto through = FindTeethThroughLips(cast_, cast_.faces[face], shape, skin_);
    if (through.vertices == 0) return;
    ++found_.teeth_through_lips;
    Add(face, expression,
        {.flaw = Flaw::kTeethThroughLips,
         .count = through.vertices,
         .measure = through.farthest_m / kMillimetre_m});
  }

  void SeekLidGaps(const face::Shape& shape, std::uint16_t face, const std::string& expression) {
    const auto seen_m2 = BallsSeen_m2(shape, mesh().triangles);
    const int eyes = (seen_m2[0] > 0 ? 1 : 0) + (seen_m2[1] > 0 ? 1 : 0);
    if (eyes == 0) return;
    found_.lid_gaps += eyes;
    const std::size_t worse = seen_m2[1] > seen_m2[0] ? 1 : 0;
    Add(face, expression,
        {.flaw = Flaw::kLidGap,
         .count = eyes,
         .measure = seen_m2[worse] / kSquareMillimetre_m2,
         .at = shape.eyes[worse].centre});
  }

  const face::Cast& cast_;
  face::Composer composer_;
  std::vector<bool> skin_;
  Inspection found_;
};

}  // namespace

Inspection Inspect(const face::Cast& cast, const std::function<void(const std::string&)>& face_begun) {
  if (cast.topology.fine.triangles.empty()) return {};
  Inspector inspector(cast);
  const auto faces = static_cast<std::uint16_t>(cast.faces.size());
  for (std::uint16_t face = 0; face < faces; ++face) {
    face_begun(cast.faces[face].name);
    inspector.InspectFace(face);
  }
  return inspector.Take();
}

std::string Say(const Finding& f) {
  std::string who = f.face + ", " + f.expression;
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
