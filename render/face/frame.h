// Where a control point lies on a face, and how the parameter space sits there: direction and size. By this
// one smile sits on a woman, a round face, a dog and a kettle (section 3 of Arai et al. 1994: an expression
// knows no face).
//
// A frame for each vertex, taken from the slope of the parameter space there, tears the lips; so one rotation
// and one size are fitted for each control point. With one topology this is a simple case of deformation
// transfer (Sumner and Popovic: "Deformation transfer for triangle meshes", 2004).
#pragma once

#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::face {

// Three directions at right angles, all of the same length: the size of the face there, 1 on a face as large
// as the parameter space says (kParameterWidth_m by kParameterHeight_m).
struct Frame {
  // Along rising u, along rising v, and their cross product, out of the face.
  glm::vec3 along_u{1, 0, 0};
  glm::vec3 along_v{0, 1, 0};
  glm::vec3 outwards{0, 0, 1};
};

// The position of each control point on a face, metres: net.surface applied to the face's positions.
std::vector<glm::vec3> PointsOnFace(const ControlNet& net, std::span<const glm::vec3> positions);

// For each control point, the rotation and the one size that fit the face best within some 3 cm: weighted
// least squares from the parameter space to the face over all points, then its polar decomposition. Fitted
// this widely it ignores the small folds of lips and nose, which would tear an expression. A point whose
// neighbours lie on one line, or on one spot of the face, gets the frame of the space itself.
std::vector<Frame> FitFrames(const ControlNet& net, std::span<const glm::vec3> on_face);

// What an expression does to the control points of the face that has these frames, metres.
std::vector<glm::vec3> Carry(const Expression& expression, std::span<const Frame> frames, float gain);
// The same, into `moved`: one for each frame. Allocates nothing.
void Carry(const Expression& expression, std::span<const Frame> frames, float gain,
           std::span<glm::vec3> moved);

// For each control point, what takes a vector of the reference face to the same vector of a face: its
// rotation and its size between the two frames.
std::vector<glm::mat3> Turns(std::span<const Frame> reference, std::span<const Frame> face);

// Adds the expression's residual to `moved` (a vertex for each row of net.to_cage), turned as the control
// points of each vertex are. On the reference face nothing turns, so there the shape is the artist's own.
void AddResidual(const ControlNet& net, const Expression& expression, std::span<const glm::mat3> turns,
                 float gain, std::span<glm::vec3> moved);

}  // namespace kaori::face
