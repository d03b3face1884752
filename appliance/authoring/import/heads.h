// Heads of one topology, split into what is skin and what is not, each with its eyes on the origin's
// level.
#pragma once

#include <array>
#include <vector>

#include "appliance/authoring/import/findings.h"
#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/model.h"
#include "appliance/authoring/import/parts.h"
#include "appliance/authoring/import/roles.h"

namespace kaori::import {

// One file's head: positions of skin vertices, moved so that the middle between the eyes lies on x = 0, y =
// 0.
struct Head {
  std::string name;
  std::vector<glm::vec3> positions;
  std::array<face::EyeBall, 2> eyes{};
  glm::vec3 shift{};  // What was added to the file's positions.
};

// A shape of the artist's or a sum of some, by skin vertex of the first head.
struct Shape {
  std::string name;
  Offsets offsets;
  std::optional<Meaning> meaning;
};

// Eyeballs are left out: the show draws its own. Teeth and tongue are kept as vertices like the skin's, since
// the artist's shapes move them.
struct Heads {
  std::vector<Head> heads;
  std::vector<PartOf> parts;        // By vertex of a model.
  std::vector<Index> skin;          // The model's vertex of each skin vertex.
  std::vector<PartOf> part;         // By skin vertex: skin, teeth or tongue.
  std::vector<Triangle> triangles;  // Of skin vertices.
  std::vector<glm::vec2> uv;        // By skin vertex.
  std::vector<Shape> shapes;        // Targets, then presets.
  std::vector<Role> roles;          // Of `shapes`.
  HeadShape by_form;  // Of the first head: what no shape says of lids, jaw and brows. Its motions alone.
  std::vector<std::string> found_by_form;  // One line for each feature.
};

// `eyes_z_m`: where the middle between the eyes is laid. Models must have passed their checks.
Heads SplitHeads(const std::vector<Model>& models, float eyes_z_m, Findings& findings);

// The sum of shapes that a role is; null where the heads have no such role.
Offsets OffsetsOfRole(const Heads& heads, std::string_view role);

// The first head with the motions by which its features are known, the artist's or else those by form; teeth
// and tongue belong to no triangle of it.
HeadShape ShapeOfHeads(const Heads& heads);

// Puts skin vertices into another order: order[i] is the vertex that becomes number i.
void Reorder(const std::vector<Index>& order, Heads& heads);

}  // namespace kaori::import
