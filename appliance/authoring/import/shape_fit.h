// Fits control points to shapes that are given as dense offsets.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/sculpt/linear_solve.h"
#include "render/face/cast.h"
#include "render/face/frame.h"

namespace kaori::import {

// How far the control points alone miss the artist's shape, in millimetres on the first head.
struct FitError {
  // Over the vertices that the shape moves by more than 0.01 mm; 0 where it moves none.
  float rms_mm = 0;
  // The worst vertex.
  float most_mm = 0;
  float shape_mm = 0;  // The farthest that the shape itself moves a vertex.
};

// Made once for a net, then used for each shape: the normal matrix (points x points) is factored in the
// constructor, and each fit substitutes twice. Borrows the net, which must outlive it; `reference` is read in
// the constructor alone. The reference face lies still. Offsets are by vertex of the cage, at least the
// moving ones, which come first.
class ShapeFit {
 public:
  // `reference`: positions of the cage's vertices on the reference face. The time grows with the third power
  // of the number of control points.
  ShapeFit(const face::ControlNet& net, std::span<const glm::vec3> reference);

  // Least squares over all moving vertices, min |W d - offsets|^2 with a little weight on d itself, solved in
  // the head's axes and then turned into each point's own frame (frame.h). What is left becomes the
  // expression's residual, so that on the reference face the shape is exact; there is none where the points
  // alone are within a micrometre. `error` is written.
  face::Expression Fit(std::string name, face::ExpressionKind kind, const Offsets& offsets,
                       FitError& error) const;

 private:
  // Displacements of the points in the head's axes, metres.
  std::vector<glm::dvec3> Solve(const Offsets& offsets) const;

  const face::ControlNet& net_;
  // Of the reference face, by point.
  std::vector<face::Frame> frames_;
  // W'W with a little on its diagonal, which makes it positive definite.
  sculpt::Factored normal_;
};

}  // namespace kaori::import
