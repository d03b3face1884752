#include "appliance/authoring/import/import.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "appliance/authoring/import/bridge.h"
#include "appliance/authoring/import/doubts.h"
#include "appliance/authoring/import/heads.h"
#include "appliance/authoring/import/imported_cast.h"
#include "appliance/authoring/import/kept_script.h"
#include "appliance/authoring/import/look.h"
#include "appliance/authoring/import/mouth_uvs.h"
#include "appliance/authoring/import/role_names.h"
#include "appliance/authoring/import/shapes_on_show.h"
#include "appliance/authoring/model/read_model.h"
#include "appliance/core/show/check.h"

namespace kaori::import {
namespace {

using face::ExpressionKind;

// How far the eyes lie before the head's middle where no show says: the cast's own woman has 5.25 cm.
constexpr float kEyesZ_m = 0.05F;

// One import; Run is called once. Expressions are collected first (`wanted_`) and fitted last, since order of
// vertices and control points follow from what all of them move.
class Importing {
 public:
  // `like`: for each head a face of the show.
  Importing(const std::vector<Model>& models, Heads heads, const show::Show* show,
            std::vector<std::size_t> like)
      : models_(models),
        heads_(std::move(heads)),
        head_(ShapeOfHeads(heads_)),
        show_(show),
        like_(std::move(like)) {}

  Imported Run(const ImportOptions& options) {
    Describe();
    if (show_ != nullptr) LayOverShow();
    WantExpressionsOfShow();
    WantByForm();
    WantOtherRoles();
    WantShapes();
    // The show's faces wear the artist's shapes where the heads could be laid over each other.
    if (to_show_) {
      made_.on_show = *show_;
      made_.report.on_show = GiveShapes(heads_, *to_show_, made_.on_show->cast);
    }
    Build(options);
    return std::move(made_);
  }

 private:
  void Remark(std::string remark) { made_.report.remarks.push_back(std::move(remark)); }

  void Describe() {
    const Model& first = models_.front();
    Remark(fmt::format("{}: {} vertices, {} triangles, {} targets, {} presets", first.file,
                       first.positions.size(), first.triangles.size(), first.targets.size(),
                       first.presets.size()));
    if (first.targets.empty())
      Remark("it has no shapes: what can be found by form moves by the show's expressions and ours");
    Remark(fmt::format("skin: {} vertices, {} triangles", heads_.skin.size(), heads_.triangles.size()));
    for (const PartOf part :
         {PartOf::kLeftEye, PartOf::kRightEye, PartOf::kUpperTeeth, PartOf::kLowerTeeth, PartOf::kTongue})
      Remark(fmt::format("{}: {} vertices", NameOf(part), std::ranges::count(heads_.parts, part)));
    for (const std::string& found : heads_.found_by_form) Remark(found);
  }

  void LayOverShow() {
    const HeadShape& theirs = head_;
    const HeadShape ours = ShapeOfCast(show_->cast);
    landmarks_ = FindLandmarks(theirs);
    std::vector<std::string> missing;
    from_show_ = Bridge::Between(ours, theirs, missing);
    to_show_ = Bridge::Between(theirs, ours, missing);
    if (!missing.empty()) Remark(fmt::format("landmarks that one head lacks: {}", fmt::join(missing, ", ")));
    if (from_show_) Remark(fmt::format("laid over the show's head by {} landmarks", from_show_->landmarks()));
    if (!from_show_)
      Remark(
          "the heads cannot be laid over each other: too few landmarks in common; nothing is carried over");
  }

  void Want(std::string name, ExpressionKind kind, Offsets offsets, std::string made_of) {
    made_.report.roles.push_back({name, std::move(made_of), {}});
    wanted_.push_back({.name = std::move(name), .kind = kind, .offsets = std::move(offsets)});
  }

  // They stay where they are in the list: the show's buttons and motions name them by index.
  void WantExpressionsOfShow() {
    if (show_ == nullptr) return Want("neutral", ExpressionKind::kExpression, {}, "the face at rest");
    for (const face::Expression& expression : show_->cast.expressions) {
      const Role* role = FindRole(heads_, expression.name);
      if (role != nullptr) {
        Want(expression.name, expression.kind, OffsetsOfRole(heads_, expression.name), MadeOf(heads_, *role));
      } else if (expression.name == "neutral") {
        Want(expression.name, expression.kind, {}, "the face at rest");
      } else {
        WantCarried(expression, expression.name);
      }
    }
    // Both heads wear the show's own, too, where the artist's took the role.
    for (const face::Expression& expression : show_->cast.expressions)
      if (FindRole(heads_, expression.name) != nullptr) WantCarried(expression, expression.name + " (show)");
  }

  // Lids are shut by the artist's own blink: it knows the eye below. So the expression is carried with open
  // lids, and the blink is added as much as the expression shuts them.
  void WantCarried(const face::Expression& expression, std::string name) {
    if (!from_show_) return Want(std::move(name), expression.kind, {}, "");
    face::Expression open = expression;
    open.lids = {};
    Offsets offsets = from_show_->Carry(DisplacementsOnShow(open));
    MoveMouthWithJaw(offsets);
    for (std::size_t side = 0; side < 2; ++side) {
      const Offsets& blink = head_.blink[side];
      for (std::size_t v = 0; v < blink.size(); ++v) offsets[v] += expression.lids[side] * blink[v];
    }
    Want(std::move(name), expression.kind, std::move(offsets), "the show's own, carried over");
    wanted_.back().pupil = expression.pupil;
  }

  // Teeth and tongue are no surface that a bridge could carry to. They go as far with the artist's jaw as the
  // lower lip does: the share of the jaw's motion in the lip's, 0..1.
  void MoveMouthWithJaw(Offsets& offsets) const {
    const HeadShape& head = head_;
    const auto lip = LandmarkAt(landmarks_, "lower lip");
    if (head.jaw.empty() || !lip) return;
    const auto nearest = std::ranges::min_element(head.positions, {},
                                                  [&](const glm::vec3& p) { return glm::distance(p, *lip); });
    const auto v = static_cast<std::size_t>(nearest - head.positions.begin());
    const glm::vec3 jaw = head.jaw[v];
    const float part =
        glm::dot(jaw, jaw) > 0 ? std::clamp(glm::dot(offsets[v], jaw) / glm::dot(jaw, jaw), 0.0F, 1.0F) : 0;
    for (std::size_t i = 0; i < offsets.size(); ++i)
      if (heads_.part[i] != PartOf::kSkin) offsets[i] = part * head.jaw[i];
  }

  // What control points do to the show's first face, without its lids: a cast of that face and that
  // expression alone, which also keeps the composer small.
  Offsets DisplacementsOnShow(const face::Expression& expression) const {
    face::Cast alone = show_->cast;
    alone.faces.resize(1);
    alone.expressions = {expression};
    alone.blink = {-1, -1};
    return OffsetsOfCast(alone, alone.expressions.front());
  }

  // Ours, where neither artist nor show says how: the show shuts lids by rings, which these heads lack.
  void WantByForm() {
    const HeadShape& form = heads_.by_form;
    for (std::size_t side = 0; side < 2; ++side)
      if (!form.blink[side].empty())
        Want(std::string(kBlinks[side]), ExpressionKind::kChannel, form.blink[side], "by form");
    const bool known = std::ranges::find(wanted_, "jaw_open", &WantedShape::name) != wanted_.end();
    if (!known && !form.jaw.empty()) Want("jaw_open", ExpressionKind::kChannel, form.jaw, "by form");
  }

  void WantOtherRoles() {
    for (const Role& role : heads_.roles)
      if (std::ranges::find(wanted_, role.name, &WantedShape::name) == wanted_.end())
        Want(role.name, KindOfRole(role.name), OffsetsOfRole(heads_, role.name), MadeOf(heads_, role));
    for (const std::string& name : KnownRoles())
      if (std::ranges::find(wanted_, name, &WantedShape::name) == wanted_.end())
        made_.report.roles.push_back({name, "", {}});
  }

  void WantShapes() {
    first_shape_ = wanted_.size();
    for (const Shape& shape : heads_.shapes) {
      const bool taken = std::ranges::find(wanted_, shape.name, &WantedShape::name) != wanted_.end();
      wanted_.push_back(
          {taken ? shape.name + " (shape)" : shape.name, ExpressionKind::kChannel, shape.offsets});
      made_.report.shapes.push_back({shape.name, MeaningIn(shape), {}});
    }
  }

  // Looks come last: they need the cast's faces. Spots were found in the order before.
  void Build(const ImportOptions& options) {
    const std::vector<Index> before = heads_.skin;
    const Index moving = OrderByMotion(heads_, wanted_);
    // Before the mouth is moved in the texture, which is a doubt of its own.
    made_.report.doubts = DoubtsAbout(heads_, ShapeOfHeads(heads_), landmarks_, moving);
    GiveMouthItsUvs();
    if (show_ != nullptr) made_.heads = *show_;
    face::Cast& cast = made_.heads.cast;
    cast = MakeCast(heads_, wanted_, moving, options.points);
    Remark(fmt::format("{} control points, {} of {} vertices move", cast.net.points.size(), moving,
                       heads_.skin.size()));
    const ShapeFit fit(cast.net, cast.faces.front().positions);
    for (std::size_t i = 0; i < wanted_.size(); ++i) cast.expressions.push_back(Fitted(fit, i, cast));
    ShadeFaces(heads_.part, cast);
    const Lender lender{show_ == nullptr ? nullptr : &show_->cast, like_, SpotsInOrder(before)};
    Remark(GiveSkin(models_.front(), heads_, lender, cast));
    Remark(DressLike(heads_, lender, cast));
    GiveScript();
  }

  // Teeth that lie over the skin in the texture would be painted onto it.
  void GiveMouthItsUvs() {
    constexpr float kBeside = 0.02F;  // Less than this is a common edge.
    const float over = MouthOverSkin(heads_);
    if (over < kBeside) return;
    if (models_.front().picture.empty()) {
      PutMouthBesideSkin(heads_);
      return Remark("teeth and tongue lay over the skin in the texture, and were moved beside it");
    }
    made_.report.doubts.push_back(fmt::format(
        "teeth and tongue wear the skin's picture: {:.0f} % of them lie over the skin in the texture",
        100 * over));
  }

  // Spots are by skin vertex in the order `before`; a file's own numbers of vertices lead to the new one.
  std::vector<Spot> SpotsInOrder(const std::vector<Index>& before) const {
    std::vector<Spot> spots;
    if (!from_show_) return spots;
    std::vector<std::size_t> at(heads_.parts.size());
    for (std::size_t i = 0; i < before.size(); ++i) at[before[i]] = i;
    for (const Index v : heads_.skin) spots.push_back(from_show_->spots()[at[v]]);
    return spots;
  }

  face::Expression Fitted(const ShapeFit& fit, std::size_t index, face::Cast& cast) {
    WantedShape& wanted = wanted_[index];
    if (wanted.offsets.empty()) wanted.offsets.assign(heads_.skin.size(), glm::vec3(0));
    FitError error;
    face::Expression expression = fit.Fit(wanted.name, wanted.kind, wanted.offsets, error);
    expression.pupil = wanted.pupil;
    const auto role = std::ranges::find(made_.report.roles, wanted.name, &ReportedRole::name);
    if (role != made_.report.roles.end()) role->error = error;
    if (index >= first_shape_) made_.report.shapes[index - first_shape_].error = error;
    for (std::size_t side = 0; side < 2; ++side)
      if (wanted.name == kBlinks[side]) cast.blink[side] = static_cast<int>(index);
    return expression;
  }

  // A show is kept but for calls of faces that it lacks now; without one, buttons call the heads.
  void GiveScript() {
    show::Show& show = made_.heads;
    show.name = heads_.heads.front().name;
    if (show_ == nullptr) {
      show.scenes.emplace_back().name = "studio";
      for (std::uint16_t i = 0; i < heads_.heads.size() && i < 8; ++i)
        show.buttons[i] = {show::CallKind::kFace, i};
    }
    const int lost_calls = DropLostFaces(show);
    if (show_ == nullptr) return;
    CarryPictures(*show_, show);
    for (std::string& remark : WhatBecameOf(show, lost_calls)) Remark(std::move(remark));
  }

  const std::vector<Model>& models_;
  Heads heads_;
  // The first, in the order before Build.
  HeadShape head_;
  const show::Show* show_;
  std::vector<std::size_t> like_;
  std::optional<Bridge> from_show_;
  std::optional<Bridge> to_show_;
  std::vector<Landmark> landmarks_;  // Of the first head.
  std::vector<WantedShape> wanted_;
  std::size_t first_shape_ = 0;
  Imported made_;
};

}  // namespace

Result<Imported> Import(const std::vector<std::filesystem::path>& files, const show::Show* show,
                        const ImportOptions& options) {
  Findings findings;
  const std::vector<Model> models = model::ReadModels(files, findings);
  if (!findings.empty()) return findings.Refuse();
  if (models.empty()) return FailInput("no file to import was named");
  std::vector<std::size_t> like =
      FacesToBeLike(options.like, files.size(), show == nullptr ? nullptr : &show->cast, findings);
  if (!findings.empty()) return findings.Refuse();
  float eyes_z_m = kEyesZ_m;
  if (show != nullptr) eyes_z_m = show->cast.faces.front().eyes[0].centre.z;
  Heads heads = SplitHeads(models, eyes_z_m, findings);
  if (!findings.empty()) return findings.Refuse();
  Imported made = Importing(models, std::move(heads), show, std::move(like)).Run(options);
  for (const show::Show* one :
       {&std::as_const(made.heads), made.on_show ? &std::as_const(*made.on_show) : nullptr}) {
    if (one == nullptr) continue;
    for (const std::string& fault : show::CheckShow(*one)) findings.Add(files.front().string(), "", fault);
  }
  if (!findings.empty()) return findings.Refuse();
  return made;
}

}  // namespace kaori::import
