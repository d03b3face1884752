#include "appliance/authoring/import/shape_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace kaori::import {
namespace {

// Keeps points near which nothing moves from running away (Tikhonov's regularisation). Against the diagonal
// of W'W, sums of squared weights of all vertices of a point, it is a thousandth or less.
constexpr double kStiffness = 1e-3;
// A micrometre: a residual that small is rounding, and would cost a list of its own in the pack and a pass
// in the frame.
constexpr float kSmallestResidual_m = 1e-6F;
constexpr float kShapeFitMoved_m = 1e-5F;
constexpr float kMillimetres = 1000;

// W'W + kStiffness I, from the sparse rows of W: each row adds the products of its weights.
sculpt::SquareMatrix NormalMatrix(const face::ControlNet& net) {
  const std::size_t n = net.points.size();
  sculpt::SquareMatrix normal(n);
  const face::SparseRows& rows = net.to_cage;
  for (std::size_t r = 0; r < rows.rows(); ++r)
    for (auto i = rows.row_start[r]; i < rows.row_start[r + 1]; ++i)
      for (auto j = rows.row_start[r]; j < rows.row_start[r + 1]; ++j)
        normal(rows.column[i], rows.column[j]) +=
            static_cast<double>(rows.weight[i]) * static_cast<double>(rows.weight[j]);
  for (std::size_t i = 0; i < n; ++i) normal(i, i) += kStiffness;
  return normal;
}

// `residual` has the moving vertices, which come first in `offsets`.
FitError Judge(const Offsets& offsets, const Offsets& residual) {
  FitError error;
  double sum = 0;
  std::size_t moved = 0;
  for (std::size_t v = 0; v < residual.size(); ++v) {
    const float miss = glm::length(residual[v]);
    const float length = glm::length(offsets[v]);
    error.most_mm = std::max(error.most_mm, kMillimetres * miss);
    error.shape_mm = std::max(error.shape_mm, kMillimetres * length);
    if (length < kShapeFitMoved_m) continue;
    sum += static_cast<double>(miss) * static_cast<double>(miss);
    ++moved;
  }
  if (moved > 0)
    error.rms_mm = kMillimetres * static_cast<float>(std::sqrt(sum / static_cast<double>(moved)));
  return error;
}

}  // namespace

ShapeFit::ShapeFit(const face::ControlNet& net, std::span<const glm::vec3> reference)
    : net_(net),
      frames_(face::FitFrames(net, face::PointsOnFace(net, reference))),
      normal_(NormalMatrix(net)) {}

// (W'W + kStiffness I)^-1 W' offsets.
std::vector<glm::dvec3> ShapeFit::Solve(const Offsets& offsets) const {
  std::vector<glm::dvec3> right(net_.points.size(), glm::dvec3(0));
  const face::SparseRows& rows = net_.to_cage;
  for (std::size_t r = 0; r < rows.rows(); ++r)
    for (auto i = rows.row_start[r]; i < rows.row_start[r + 1]; ++i)
      right[rows.column[i]] += static_cast<double>(rows.weight[i]) * glm::dvec3(offsets[r]);
  normal_.Solve(right);
  return right;
}

// Three steps: how the points move in the head's axes, the same in each point's own frame, and what the net
// misses even then, vertex by vertex.
face::Expression ShapeFit::Fit(std::string name, face::ExpressionKind kind, const Offsets& offsets,
                               FitError& error) const {
  face::Expression expression{
      .name = std::move(name), .kind = kind, .displacement = {}, .lids = {}, .residual = {}};
  const std::vector<glm::dvec3> solved = Solve(offsets);
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const face::Frame& frame = frames_[i];
    // From the head's axes into the point's frame on the reference face, which Composer turns back; frames
    // are a rotation and a scale there, never flat.
    expression.displacement.push_back(glm::inverse(glm::mat3(frame.along_u, frame.along_v, frame.outwards)) *
                                      glm::vec3(solved[i]));
  }
  const face::SparseRows& rows = net_.to_cage;
  // offsets - W d.
  Offsets residual(offsets.begin(), offsets.begin() + static_cast<std::ptrdiff_t>(rows.rows()));
  for (std::size_t r = 0; r < rows.rows(); ++r)
    for (auto i = rows.row_start[r]; i < rows.row_start[r + 1]; ++i)
      residual[r] -= rows.weight[i] * glm::vec3(solved[rows.column[i]]);
  error = Judge(offsets, residual);
  const bool exact =
      std::ranges::all_of(residual, [](const glm::vec3& r) { return glm::length(r) < kSmallestResidual_m; });
  if (!exact) expression.residual = std::move(residual);
  return expression;
}

}  // namespace kaori::import
