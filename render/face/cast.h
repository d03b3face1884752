// A cast: faces on one topology, expressions that know no face, and what is worn with them.
// Metres, right-handed: +Y up, +Z out of the face to the audience, +X to the character's left. The origin is
// midway between the eyes of the reference face. Colours are linear RGB.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/face/texels.h"
#include "render/face/topology.h"

namespace kaori::face {

// A solid ball that fills the socket; the iris is drawn on it, turned by the gaze.
struct EyeBall {
  glm::vec3 centre{};
  // 0: the face shows no ball there.
  float radius_m = 0;
  // The lid's margin rides this far above the ball.
  float lid_thickness_m = 0;
};

// How a face's iris and lashes look. Blended with the face.
struct EyeLook {
  // The colour of the iris.
  glm::vec3 iris{};
  // Measured along the ball's surface, from the pupil's middle.
  float iris_radius_m = 0;
  // The longest of the upper lid's lashes; 0: none.
  float lash_length_m = 0;
  // How far the outer lashes reach out beyond the eye.
  float lash_wing_m = 0;
};

// How a face's eyeballs are painted, and how they answer light. Blended with the face. Shares count 0..1 but
// where something else is said.
struct EyeSurface {
  // The ball's colour about the iris.
  glm::vec3 white{0.896F, 0.863F, 0.855F};
  // How red the white is towards its edges.
  float veins = 0.22F;
  // The pupil's radius, of the iris's.
  float pupil = 0.48F;
  // How dark the iris is at its rim; below 0, down to -1, how pale: the ring of old age.
  float limbus = 0.78F;
  // How much of fine spokes, and of the rings of a lens.
  float spokes = 1;
  float rings = 0;
  // How wet the ball is: the lamp's highlight, and the line of tears on the lower lid.
  float wet = 1;
  // The iris's light of its own, which no shade dims.
  float glow = 0;
};

// Where the shared teeth and tongue sit in a face: p -> (p - anchor) * scale + anchor + offset, in metres,
// with Cast::mouth_anchor. Blended with the face; the shares count 0 hidden .. 1 shown.
struct MouthFit {
  // 1 and no offset: as the reference face wears them.
  float scale = 1;
  glm::vec3 offset{};
  float upper_teeth = 1;
  float lower_teeth = 1;
  float tongue = 1;
};

// How a face's surface answers light. Blended with the face, but for the texture, which is cross-faded.
struct SurfaceLook {
  // 1: skin, light bleeds into shade (red most); 0: hard.
  float softness = 1;
  // 1: a polished kettle.
  float metal = 0;
  // Index into Cast::textures.
  int texture = 0;
  // The one colour of the flat-shaded style.
  glm::vec3 flat{};
  // 0..1; 1: a poster, printed with dots and few inks.
  float print = 0;
  // 0..1: how deep wrinkles are where its skin is pressed together, in the fine qualities. 0: wood, or a child's.
  float folds = 1;
  // 0..1: how much it shows of the red of expressions. 1: a kettle on the fire.
  float flush = 0;
};

// The global shape (the paper's section 3): one position for each vertex of the cage, made in a modelling
// tool. B_i in equation 1 as Weights writes it.
struct Face {
  // Unique in its cast; what operators and files call it by.
  std::string name;
  // Topology::vertex_count positions, metres.
  std::vector<glm::vec3> positions;
  // For each cage vertex 0 shut in .. 1 open to the sky; baked. Empty: open everywhere.
  std::vector<float> occlusion;
  // [0] the character's left (+X), [1] the right.
  std::array<EyeBall, 2> eyes{};
  EyeLook eye_look;
  EyeSurface eye_surface;
  MouthFit mouth;
  SurfaceLook surface;
  // Indices into Cast::props: its hair, its clothes, its teeth and tongue.
  std::vector<int> props;
  // What the head's outgrowths are like, 0..1: ears, or a handle. While faces that differ in this are mixed,
  // outgrowths withdraw: half-way between ears and a handle lie horns.
  float outgrowth_kind = 0;
  // How far each vertex of Topology::outgrowth moves when it is withdrawn, metres. Empty: not at all.
  std::vector<glm::vec3> withdrawn;
  // How far each vertex of Topology::outgrowth moves for each radian of the upper joint (x) and of the lower one (y) of what
  // hangs at its side, metres. Empty: nothing of this face hangs.
  std::vector<glm::vec2> hang_arms_m;
  // What displacements are multiplied with on this face: a kettle has to try harder.
  float expression_gain = 1;
  // Of the fine mesh: triangles that show this face alone as FineMesh::triangles do, with larger ones where it is
  // flat in all that it does. Normals are those of FineMesh::triangles. Empty: there are no fewer.
  std::vector<Triangle> sparse;
};

// A control point of expressions.
struct ControlPoint {
  // Unique in its net, and per side: "MC.l" and "MC.r" are partners, "UC" lies in the middle.
  std::string name;
  // Where it lies in the parameter space, within the unit square.
  glm::vec2 uv{};
};

// The control points and the interpolant from them to the cage: W in P = B + W d (the paper's section 3).
// Border points hold zero and carry no column, so a vertex near them simply has rows that sum to less than 1.
struct ControlNet {
  // Points that move, in the order of every displacement list.
  std::vector<ControlPoint> points;
  // Topology::moving_count rows, |points| columns. The paper interpolates piecewise linearly over a
  // triangulation of the points in the parameter space; here the same weights are smoothed over the mesh,
  // which halves the roughness.
  SparseRows to_cage;
  // |points| rows over cage vertices: where each point lies on a face. Rows sum to 1.
  SparseRows surface;
};

enum class ExpressionKind : std::uint8_t {
  // One of the faces that an operator calls; the weights of these sum to 1 (t_j).
  kExpression,
  // A mouth shape (vowels and the like), played on top.
  kMouth,
  // Brows, gaze lids, jaw; played on top, with a weight of its own (c_k).
  kChannel,
};

// The local shape (the paper's section 3): what the control points do. It knows no face; frame.h says how a
// face wears it.
struct Expression {
  // Unique in its cast.
  std::string name;
  ExpressionKind kind = ExpressionKind::kExpression;
  // For each control point a displacement along u, along v and outwards, in metres on the reference face
  // (Cast::faces[0]).
  std::vector<glm::vec3> displacement;
  // How far lids are shut as part of the expression: left, right, 0..1.
  std::array<float, 2> lids{};
  // How large the pupils are in it, as a factor, 0.5..1.5.
  float pupil = 1;
  // How red it makes a surface that shows it (SurfaceLook::flush), 0..1.
  float flush = 0;
  // What the control points cannot say of a shape that came from a modelling tool: one offset for each moving
  // vertex of the reference face, metres along the head's axes. Empty: nothing.
  std::vector<glm::vec3> residual{};
};

// What a prop is decides how it is drawn, and whether it turns with the head: clothes do not.
enum class Part : std::uint8_t { kHair, kUpperTeeth, kLowerTeeth, kTongue, kClothes };

// `along` and `across` run 0..1 over a lock of hair, from the root and from one edge; teeth, tongue and
// clothes use `shade` alone.
struct PropVertex {
  // Metres, the head's frame at rest.
  glm::vec3 position{};
  // Unit.
  glm::vec3 normal{};
  // Unit, along the lock, towards its tip.
  glm::vec3 tangent{};
  float along = 0;
  float across = 0;
  // Baked occlusion: 0 shut in .. 1 open.
  float shade = 1;
};

// A mesh that does not deform.
struct Prop {
  // Unique in its cast by custom: tools match props by it.
  std::string name;
  Part part = Part::kHair;
  // Linear RGB; the whole prop has one.
  glm::vec3 colour{};
  std::vector<PropVertex> vertices;
  // Of its own vertices.
  std::vector<Triangle> triangles;
};

// A skin, or a backdrop's picture: RGBA, 8 bit each, sRGB, top row first. Alpha is gloss (0 matt, 255 wet)
// and linear.
struct Texture {
  // Each 1 to 8192.
  int width_px = 0;
  int height_px = 0;
  // width * height * 4 bytes.
  Texels rgba;
};

// Everything that faces are made of. Filled once (by a pack or by the authoring tools), then read by one
// thread at a time; only an expression in work changes while it plays (Composer::Renew).
struct Cast {
  Topology topology;
  ControlNet net;
  // [0] is the reference face, on which expressions are measured.
  std::vector<Face> faces;
  // [0] is "neutral"; kinds may be mixed.
  std::vector<Expression> expressions;
  std::vector<Prop> props;
  std::vector<Texture> textures;
  // The head turns about this point.
  glm::vec3 neck_pivot{};
  // See MouthFit.
  glm::vec3 mouth_anchor{};
  // Expressions that shut the left and the right lids of a topology without rings (Topology::lids); -1: none.
  std::array<int, 2> blink{-1, -1};
};

}  // namespace kaori::face
