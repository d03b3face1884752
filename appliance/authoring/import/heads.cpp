#include "appliance/authoring/import/heads.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/import/doubts.h"
#include "appliance/authoring/import/form.h"
#include "appliance/authoring/model/mesh_check.h"

namespace kaori::import {
namespace {

constexpr Index kNoSkin = std::numeric_limits<Index>::max();
// What is left of a tongue's height, and how far its tip is drawn back.
constexpr float kTongueFlat = 0.35F, kTongueBack_m = 0.009F;

bool IsEye(PartOf part) {
  return part == PartOf::kLeftEye || part == PartOf::kRightEye;
}

// Numbers what is no eyeball in the order of the file, and renumbers its triangles. A triangle belongs to one
// piece, so its first corner tells.
void SeparateSkin(const Model& model, Heads& heads) {
  std::vector<Index> number(model.positions.size(), kNoSkin);
  for (Index v = 0; v < number.size(); ++v) {
    if (IsEye(heads.parts[v])) continue;
    number[v] = static_cast<Index>(heads.skin.size());
    heads.skin.push_back(v);
    heads.part.push_back(heads.parts[v]);
    heads.uv.push_back(model.uv[v]);
  }
  for (const Triangle& t : model.triangles)
    if (!IsEye(heads.parts[t[0]])) heads.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
}

// Where the middle between the eyes is: between the eyeballs; without them where the blinks move most (the
// mean of positions, weighted by squared offsets); else at three fifths of the head's height.
glm::vec3 MiddleOfEyes(const Model& model, const Heads& heads, const Head& head) {
  if (head.eyes[0].radius_m > 0 && head.eyes[1].radius_m > 0)
    return 0.5F * (head.eyes[0].centre + head.eyes[1].centre);
  glm::vec3 sum{};
  float weight = 0;
  for (const char* role : {"blink_left", "blink_right"})
    if (const Target* blink = FindTarget(model, role))
      for (std::size_t v = 0; v < blink->offsets.size(); ++v) {
        const float w = glm::dot(blink->offsets[v], blink->offsets[v]);
        sum += w * model.positions[v];
        weight += w;
      }
  if (weight > 0) return sum / weight;
  glm::vec3 least = model.positions.front();
  glm::vec3 most = least;
  for (const Index v : heads.skin) {
    least = glm::min(least, model.positions[v]);
    most = glm::max(most, model.positions[v]);
  }
  return {0.5F * (least.x + most.x), least.y + 0.6F * (most.y - least.y), 0.5F * (least.z + most.z)};
}

// Each head gets its own shift, so that a large and a small one look into the camera alike. Sizes stay as the
// artist made them.
Head MakeHead(const Model& model, const Heads& heads, float eyes_z_m) {
  Head head;
  head.name = std::filesystem::path(model.file).stem().string();
  const std::array eyes{PartOf::kLeftEye, PartOf::kRightEye};
  for (std::size_t side = 0; side < 2; ++side)
    head.eyes[side] = FitBall(model, heads.parts, eyes[side]).value_or(face::EyeBall{});
  const glm::vec3 middle = MiddleOfEyes(model, heads, head);
  head.shift = glm::vec3(0, 0, eyes_z_m) - middle;
  for (const Index v : heads.skin) head.positions.push_back(model.positions[v] + head.shift);
  for (face::EyeBall& eye : head.eyes) eye.centre += head.shift;
  return head;
}

// Two files may have one name: woman.glb, woman.obj. Operators call faces by name, so a number is added.
std::string FreeName(const Heads& heads, const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; std::ranges::find(heads.heads, name, &Head::name) != heads.heads.end(); ++number)
    name = fmt::format("{}-{}", wanted, number);
  return name;
}

// From one offset for each vertex of the model to one for each that is kept.
Offsets OnSkin(const Heads& heads, const Offsets& offsets) {
  Offsets on_skin;
  for (const Index v : heads.skin) on_skin.push_back(offsets[v]);
  return on_skin;
}

// `sum` may be empty at first.
void Accumulate(const Offsets& from, float weight, Offsets& sum) {
  sum.resize(from.size());
  for (std::size_t v = 0; v < from.size(); ++v) sum[v] += weight * from[v];
}

// A preset is summed up from targets of the same file; one whose targets are all missing is left out.
void AddShapes(const Model& model, Heads& heads) {
  for (const Target& target : model.targets)
    heads.shapes.push_back(
        {target.name, OnSkin(heads, target.offsets), MeaningOf(target.name, NameOrigin::kTarget)});
  const std::size_t targets = heads.shapes.size();
  for (const model::Preset& preset : model.presets) {
    Offsets sum;
    for (const model::PresetPart& part : preset.parts)
      for (std::size_t i = 0; i < targets; ++i)
        if (heads.shapes[i].name == part.target) Accumulate(heads.shapes[i].offsets, part.weight, sum);
    if (!sum.empty())
      heads.shapes.push_back({preset.name, std::move(sum), MeaningOf(preset.name, NameOrigin::kPreset)});
  }
}

// Only the motions that no role has: CompleteByForm has filled a copy that has the artist's, too.
void KeepByForm(HeadShape completed, Heads& heads) {
  const auto keep = [&](std::string_view role, Offsets& from, Offsets& to) {
    if (std::ranges::find(heads.roles, role, &Role::name) == heads.roles.end()) to = std::move(from);
  };
  HeadShape& form = heads.by_form;
  keep("jaw_open", completed.jaw, form.jaw);
  keep("blink_left", completed.blink[0], form.blink[0]);
  keep("blink_right", completed.blink[1], form.blink[1]);
  keep("brow_up_left", completed.brow_up[0], form.brow_up[0]);
  keep("brow_up_right", completed.brow_up[1], form.brow_up[1]);
  form.lids = completed.lids;
}

// Modellers make a tongue that fills the mouth, as it does while the lips are shut; with the jaw's own motion
// it then stands before the upper teeth as a wall. At rest nobody sees it, so it is laid down: flatter, from
// its lower side, and drawn back from the teeth at its tip.
void LayDownTongue(const std::vector<PartOf>& part, std::vector<glm::vec3>& positions) {
  float low = std::numeric_limits<float>::max(), back = low, front = std::numeric_limits<float>::lowest();
  for (std::size_t v = 0; v < part.size(); ++v) {
    if (part[v] != PartOf::kTongue) continue;
    low = std::min(low, positions[v].y);
    back = std::min(back, positions[v].z);
    front = std::max(front, positions[v].z);
  }
  for (std::size_t v = 0; v < part.size(); ++v) {
    if (part[v] != PartOf::kTongue) continue;
    glm::vec3& at = positions[v];
    const float tip = front > back ? (at.z - back) / (front - back) : 0.0F;
    at.y = low + (at.y - low) * kTongueFlat;
    at.z -= kTongueBack_m * tip;
  }
}

// values[i] becomes what was at order[i].
template <class T>
void Reorder(const std::vector<Index>& order, std::vector<T>& values) {
  std::vector<T> ordered;
  ordered.reserve(order.size());
  for (const Index v : order) ordered.push_back(values[v]);
  values = std::move(ordered);
}

}  // namespace

// The first model decides for all what is skin, since they have one topology; its shapes and features
// are the heads'.
Heads SplitHeads(const std::vector<Model>& models, float eyes_z_m, Findings& findings) {
  const Model& first = models.front();
  Heads heads;
  heads.parts = FindParts(first, MeshGraph(first.positions, first.triangles));
  SeparateSkin(first, heads);
  // In vertices of the model, as CheckUnfolding counts them; eyeballs may be unfolded as they like.
  std::vector<Triangle> skin;
  for (const Triangle& t : first.triangles)
    if (!IsEye(heads.parts[t[0]])) skin.push_back(t);
  model::CheckUnfolding(first, skin, findings);
  for (const Model& model : models) {
    Head head = MakeHead(model, heads, eyes_z_m);
    head.name = FreeName(heads, head.name);
    LayDownTongue(heads.part, head.positions);
    heads.heads.push_back(std::move(head));
  }
  AddShapes(first, heads);
  std::vector<std::optional<Meaning>> meanings;
  for (const Shape& shape : heads.shapes) meanings.push_back(shape.meaning);
  heads.roles = FindRoles(meanings);
  HeadShape completed = ShapeOfHeads(heads);
  heads.found_by_form = CompleteByForm(heads.part, completed);
  KeepByForm(std::move(completed), heads);
  CheckPose(first, heads, findings);
  return heads;
}

Offsets OffsetsOfRole(const Heads& heads, std::string_view name) {
  Offsets sum;
  const auto role = std::ranges::find(heads.roles, name, &Role::name);
  if (role == heads.roles.end()) return sum;
  for (const RolePart& part : role->parts) Accumulate(heads.shapes[part.shape].offsets, part.weight, sum);
  return sum;
}

// Roles first, form where there is none.
HeadShape ShapeOfHeads(const Heads& heads) {
  const Head& first = heads.heads.front();
  HeadShape shape{first.positions, {}, first.eyes, {}, {}, {}};
  // Without teeth and tongue: the landmarks and the bridge want the skin alone.
  for (const Triangle& t : heads.triangles)
    if (heads.part[t[0]] == PartOf::kSkin) shape.triangles.push_back(t);
  shape.jaw = OffsetsOfRole(heads, "jaw_open");
  shape.blink = {OffsetsOfRole(heads, "blink_left"), OffsetsOfRole(heads, "blink_right")};
  shape.brow_up = {OffsetsOfRole(heads, "brow_up_left"), OffsetsOfRole(heads, "brow_up_right")};
  const HeadShape& form = heads.by_form;
  if (shape.jaw.empty()) shape.jaw = form.jaw;
  for (std::size_t side = 0; side < 2; ++side) {
    if (shape.blink[side].empty()) shape.blink[side] = form.blink[side];
    if (shape.brow_up[side].empty()) shape.brow_up[side] = form.brow_up[side];
    shape.lids[side] = form.lids[side];
  }
  return shape;
}

// `parts` stays as it is: it goes by the vertices of the model, which keep their numbers.
void Reorder(const std::vector<Index>& order, Heads& heads) {
  // The inverse permutation, for the triangles.
  std::vector<Index> number(order.size());
  for (Index i = 0; i < order.size(); ++i) number[order[i]] = i;
  for (Head& head : heads.heads) Reorder(order, head.positions);
  Reorder(order, heads.skin);
  Reorder(order, heads.part);
  Reorder(order, heads.uv);
  HeadShape& form = heads.by_form;
  for (Offsets* motion : {&form.jaw, &form.blink[0], &form.blink[1], &form.brow_up[0], &form.brow_up[1]})
    if (!motion->empty()) Reorder(order, *motion);
  for (Shape& shape : heads.shapes) Reorder(order, shape.offsets);
  for (Triangle& t : heads.triangles)
    for (Index& corner : t) corner = number[corner];
}

}  // namespace kaori::import
