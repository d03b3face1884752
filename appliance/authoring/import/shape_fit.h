// Fits control points to shapes that are given as dense offsets.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "render/face/cast.h"
#include "render/face/frame.h"

namespace kaori::import {

// How far the control points alone miss the artist's shape.
struct FitError {
  float rms_mm = 0;  // Over the vertices that the shape moves.
  float most_mm = 0;
  float shape_mm = 0;  // The farthest that the shape itself moves a vertex.
};

// Borrows the net; its reference face lies still. Rows of offsets are vertices of the cage, at least the
// moving ones.
class ShapeFit {
 public:
  ShapeFit(const face::ControlNet& net, std::span<const glm::vec3> reference);

  // Least squares over all moving vertices; what is left becomes the expression's residual, so that on the
  // reference face the shape is exact.
  face::Expression Fit(std::string name, face::ExpressionKind kind, const Offsets& offsets,
                       FitError& error) const;

 private:
  std::vector<glm::dvec3> Solve(const Offsets& offsets) const;

  const face::ControlNet& net_;
  std::vector<face::Frame> frames_;
  std::vector<double> inverse_;  // Of the normal matrix, row by row.
};

}  // namespace kaori::import
