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

struct EyeBall {
  glm::vec3 centre{};
  float radius_m = 0;
  float lid_thickness_m = 0;  // The lid's margin rides this far above the ball.
};

// How a face's iris and lashes look.
struct EyeLook {
  glm::vec3 iris{};         // Colour.
  float iris_radius_m = 0;  // Measured along the ball's surface.
  float lash_length_m = 0;  // 0: none.
  float lash_wing_m = 0;    // How far the outer lashes reach out beyond the eye.
};

// Where the shared teeth and tongue sit in a face: p -> (p - anchor) * scale + anchor + offset.
struct MouthFit {
  float scale = 1;
  glm::vec3 offset{};
  float upper_teeth = 1;  // 0 hides them, 1 shows them.
  float lower_teeth = 1;
  float tongue = 1;
};

// How a face's surface answers light.
struct SurfaceLook {
  float softness = 1;  // 1: skin, light bleeds into shade (red most); 0: hard.
  float metal = 0;     // 1: a polished kettle.
  int texture = 0;     // Index into Cast::textures.
  glm::vec3 flat{};    // The one colour of the flat-shaded style.
  float print = 0;     // 1: a poster, printed with dots and few inks.
};

// The global shape: one position for each vertex of the cage.
struct Face {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<float> occlusion;   // Per cage vertex: 0 shut in, 1 open to the sky.
  std::array<EyeBall, 2> eyes{};  // [0] the character's left (+X).
  EyeLook eye_look;
  MouthFit mouth;
  SurfaceLook surface;
  std::vector<int> props;     // Indices into Cast::props: its hair, its clothes.
  float expression_gain = 1;  // A kettle has to try harder.
};

// A control point: its place in the parameter space. Names are per side: "MC.l", "UC".
struct ControlPoint {
  std::string name;
  glm::vec2 place{};
};

// Control points and the interpolant from them to the cage: W in P = B + W d. Rows of vertices at or
// above Topology::moving_count do not exist; border points hold zero and carry no column.
struct ControlNet {
  std::vector<ControlPoint> points;
  SparseRows to_cage;         // moving_count rows, |points| columns; smoothed for display.
  SparseRows to_cage_linear;  // The paper's piecewise linear interpolant; the reference.
  SparseRows surface;         // |points| rows over cage vertices: where a point lies on a face.
};

enum class ExpressionKind : std::uint8_t {
  kExpression,  // One of the faces that an operator calls; their weights sum to 1.
  kMouth,       // A mouth shape (vowels and the like), played on top.
  kChannel,     // Brows, gaze lids, jaw; played on top, with a weight of its own.
};

// The local shape: for each control point a displacement along u, along v and outwards, in metres on the
// reference face (Cast::faces[0]). It knows no face.
struct Expression {
  std::string name;
  ExpressionKind kind = ExpressionKind::kExpression;
  std::vector<glm::vec3> displacement;  // One for each control point.
  std::array<float, 2> lids{};  // Lids shut by this much as part of the expression: left, right, 0..1.
  // What the control points cannot say of a shape that came from a modelling tool: one offset for each moving
  // vertex of the reference face, metres along the head's axes. Empty: nothing.
  std::vector<glm::vec3> residual{};
};

enum class Part : std::uint8_t { kHair, kUpperTeeth, kLowerTeeth, kTongue, kClothes };

// `along` and `across` run 0..1 over a lock of hair; teeth and tongue use `shade` alone.
struct PropVertex {
  glm::vec3 position{};
  glm::vec3 normal{};
  glm::vec3 tangent{};  // Along the lock, towards its tip.
  float along = 0;
  float across = 0;
  float shade = 1;  // Baked occlusion, 0..1.
};

// A mesh that does not deform. Hair and teeth turn with the head, clothes do not.
struct Prop {
  std::string name;
  Part part = Part::kHair;
  glm::vec3 colour{};
  std::vector<PropVertex> vertices;
  std::vector<Triangle> triangles;
};

// RGBA, 8 bit, sRGB, top row first. Alpha is gloss (0 matt, 255 wet).
struct Texture {
  int width_px = 0;
  int height_px = 0;
  Texels rgba;
};

struct Cast {
  Topology topology;
  ControlNet net;
  std::vector<Face> faces;              // [0] is the reference face, on which expressions are measured.
  std::vector<Expression> expressions;  // [0] is "neutral"; kinds may be mixed.
  std::vector<Prop> props;
  std::vector<Texture> textures;
  glm::vec3 neck_pivot{};    // The head turns about this point.
  glm::vec3 mouth_anchor{};  // See MouthFit.
  // Expressions that shut the left and the right lids of a topology without rings (Topology::lids); -1: none.
  std::array<int, 2> blink{-1, -1};
};

}  // namespace kaori::face
