// Heads of one topology, split into what is skin and what is not, each with its eyes on the origin's
// level.
#pragma once

#include <array>
#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/parts.h"
#include "appliance/authoring/import/roles.h"
#include "appliance/authoring/model/findings.h"
#include "appliance/authoring/model/model.h"

namespace kaori::import {

using model::Findings;

// One file's head: positions of skin vertices in metres, moved so that the middle between the eyes lies on x
// = 0, y = 0, and at the depth that SplitHeads was given.
struct Head {
  // The file's name without its ending; "woman-2" where two files have one.
  std::string name;
  // By skin vertex.
  std::vector<glm::vec3> positions;
  // Fitted to the eyeballs' vertices; radius 0 where the file has none.
  std::array<face::EyeBall, 2> eyes{};
  glm::vec3 shift{};  // What was added to the file's positions.
};

// A target of the artist's, or a preset: the weighted sum of some. One offset for each skin vertex of
// the first head.
struct Shape {
  // As the file spells it.
  std::string name;
  Offsets offsets;
  // What its name means by the tables of roles.h; none where it is nobody's word.
  std::optional<Meaning> meaning;
};

// All heads of an import, on the one topology of the first file. Eyeballs are left out: the show draws its
// own. Teeth and tongue are kept as vertices like the skin's, since the artist's shapes move them; "skin
// vertex" below means all that is kept.
struct Heads {
  // One for each file, in the order of the files; never empty.
  std::vector<Head> heads;
  // By vertex of the first model; equal for the others, whose topology it is.
  std::vector<PartOf> parts;
  // The model's vertex of each skin vertex. It keeps the way back to the file after Reorder.
  std::vector<Index> skin;
  std::vector<PartOf> part;         // By skin vertex: skin, teeth or tongue.
  std::vector<Triangle> triangles;  // Of skin vertices.
  std::vector<glm::vec2> uv;        // By skin vertex.
  // Targets in the order of the file, then presets.
  std::vector<Shape> shapes;
  // Their parts are indices into `shapes`.
  std::vector<Role> roles;
  // Of the first head: what no shape says of lids, jaw and brows. Its motions alone; positions and
  // triangles are empty.
  HeadShape by_form;
  // What CompleteByForm said: one line for each feature.
  std::vector<std::string> found_by_form;
};

// `eyes_z_m`: the depth to which the middle between the eyes is moved; a show's own eyes stand there, so its
// cameras and collars fit. `models` must not be empty, and must have passed CheckModel and CheckSameTopology.
// Faults of the parameter space of the first, and of how it stands (CheckPose), go to `findings`; the heads are then not to be used.
Heads SplitHeads(const std::vector<Model>& models, float eyes_z_m, Findings& findings);

// The weighted sum of shapes that a role is, by skin vertex; empty where the heads have no such role.
Offsets OffsetsOfRole(const Heads& heads, std::string_view role);

// The first head with the motions by which its features are known, the artist's or else those by form. Teeth
// and tongue belong to no triangle of it, so that they neither hide the lips nor count as skin.
HeadShape ShapeOfHeads(const Heads& heads);

// Puts skin vertices into another order, in every list that is by skin vertex: order[i] is the vertex that
// becomes number i. `order` is a permutation. Shapes, roles and names stay as they are.
void Reorder(const std::vector<Index>& order, Heads& heads);

}  // namespace kaori::import
