#include "tests/appliance/authoring/import_head.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "appliance/authoring/import/head_shape.h"
#include "tests/appliance/authoring/import_glb.h"
#include "tests/render/default_cast.h"

namespace kaori::import {
namespace {

using model::GlbMaker;
using model::Target;

constexpr glm::vec3 kStands{0, 1.5F, 0.1F};

void AddBall(const face::EyeBall& eye, Model& model) {
  constexpr Index kAround = 12;
  constexpr Index kUp = 8;
  const auto first = static_cast<Index>(model.positions.size());
  for (Index row = 1; row < kUp; ++row)
    for (Index column = 0; column < kAround; ++column) {
      const float up = glm::radians(180.0F * static_cast<float>(row) / static_cast<float>(kUp));
      const float round = glm::radians(360.0F * static_cast<float>(column) / static_cast<float>(kAround));
      model.positions.push_back(eye.centre + eye.radius_m * glm::vec3(std::sin(up) * std::cos(round),
                                                                      std::cos(up),
                                                                      std::sin(up) * std::sin(round)));
      model.uv.emplace_back(static_cast<float>(column) / 100, static_cast<float>(row) / 100);
    }
  for (Index row = 0; row + 2 < kUp; ++row)
    for (Index column = 0; column < kAround; ++column) {
      const auto at = [&](Index r, Index c) { return first + r * kAround + c % kAround; };
      model.triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1)});
      model.triangles.push_back({at(row, column), at(row + 1, column + 1), at(row + 1, column)});
    }
}

void AddTarget(const char* name, Offsets offsets, Model& model) {
  if (!offsets.empty()) model.targets.push_back({name, std::move(offsets)});
}

const face::Expression& Named(const face::Cast& cast, std::string_view name) {
  return *std::ranges::find(cast.expressions, name, &face::Expression::name);
}

// A ring of triangles about the head, a centimetre off, where hair would be.
face::Prop Cap(const face::Face& face) {
  face::Prop cap;
  cap.name = "cap";
  for (Index v = 0; v + 2 < face.positions.size(); v += 3) {
    const glm::vec3 p = face.positions[v];
    if (p.y < 0.05F) continue;
    const auto first = static_cast<Index>(cap.vertices.size());
    const glm::vec3 out = glm::normalize(glm::vec3(p.x, p.y - 0.03F, p.z));
    for (const glm::vec3& corner : {glm::vec3(0), glm::vec3(0.002F, 0, 0), glm::vec3(0, 0.002F, 0)})
      cap.vertices.push_back({.position = p + 0.01F * out + corner, .normal = out, .tangent = {0, -1, 0}});
    cap.triangles.push_back({first, first + 1, first + 2});
  }
  return cap;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "kaori-import-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) std::abort();
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Model ExportedHead() {
  const face::Cast& cast = tests::DefaultCast();
  const HeadShape shape = ShapeOfCast(cast);
  Model model;
  model.file = "head";
  model.positions = shape.positions;
  model.uv = cast.topology.uv;
  model.triangles = shape.triangles;
  for (const face::EyeBall& eye : shape.eyes) AddBall(eye, model);
  AddTarget("jawOpen", shape.jaw, model);
  AddTarget("eyeBlink_L", shape.blink[0], model);
  AddTarget("eyeBlink_R", shape.blink[1], model);
  AddTarget("browOuterUpLeft", shape.brow_up[0], model);
  AddTarget("browOuterUpRight", shape.brow_up[1], model);
  AddTarget("wibble", OffsetsOfCast(cast, Named(cast, "funny")), model);
  for (Target& target : model.targets) target.offsets.resize(model.positions.size());
  for (glm::vec3& p : model.positions) p = kHeadScale * p + kStands;
  for (Target& target : model.targets)
    for (glm::vec3& offset : target.offsets) offset *= kHeadScale;
  return model;
}

void WriteGlb(const std::filesystem::path& file, const Model& model) {
  GlbMaker maker;
  maker.AddModel(model, "head");
  const auto bytes = maker.Glb();
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

const show::Show& DefaultShow() {
  static const show::Show show = [] {
    show::Show made;
    made.name = "default";
    made.cast = tests::DefaultCast();
    made.cast.props = {Cap(made.cast.faces.front())};
    for (face::Face& face : made.cast.faces) face.props = {0};
    made.cast.textures.push_back({1, 1, {200, 150, 120, 40}});
    made.scenes.emplace_back().name = "studio";
    made.buttons[0] = {show::CallKind::kFace, 4};
    made.buttons[1] = {show::CallKind::kFace, 0};
    made.second_buttons[0] = {show::CallKind::kFace, 4, show::CallMode::kToggle};
    made.second_buttons[1] = {show::CallKind::kFace, 0, show::CallMode::kToggle};
    made.keys = {{0x14, {show::CallKind::kFace, 4, show::CallMode::kMomentary}}};
    made.face_fades.resize(made.cast.faces.size());
    return made;
  }();
  return show;
}

}  // namespace kaori::import
