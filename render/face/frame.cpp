#include "render/face/frame.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

namespace kaori::face {
namespace {

// Of the Gaussian weight. Narrower fits follow the folds of the lips.
constexpr double kFitRadius_m = 0.016;
// A fit this much thinner in one direction than in the other has no frame.
constexpr double kFlat = 1e-6;

glm::dvec2 InMetres(glm::vec2 uv) {
  return {static_cast<double>(uv.x) * static_cast<double>(kParameterWidth_m),
          static_cast<double>(uv.y) * static_cast<double>(kParameterHeight_m)};
}

// The linear map from parameter space to space, as its two columns.
struct Slope {
  glm::dvec3 along_u{};
  glm::dvec3 along_v{};
};

// The determinant against the square of the trace: a measure of how thin that does not depend on the size.
bool Flat(const glm::dmat2& m) {
  const double trace = m[0][0] + m[1][1];
  return !(glm::determinant(m) > kFlat * kFlat * trace * trace);
}

// Sums of the normal equations: moments of the steps in the parameter space, and of the points against them.
struct Moments {
  glm::dmat2 steps{0.0};
  Slope points;

  void Add(glm::dvec2 step_m, glm::dvec3 point) {
    const double weight = std::exp(-glm::dot(step_m, step_m) / (2 * kFitRadius_m * kFitRadius_m));
    steps += weight * glm::outerProduct(step_m, step_m);
    points.along_u += weight * step_m.x * point;
    points.along_v += weight * step_m.y * point;
  }

  Slope Solve() const {
    const glm::dmat2 inverse = glm::inverse(steps);
    return {points.along_u * inverse[0][0] + points.along_v * inverse[0][1],
            points.along_u * inverse[1][0] + points.along_v * inverse[1][1]};
  }
};

// The polar decomposition of the slope, by the square root of J^T J (for two columns in closed form).
// J = R S: R keeps the direction nearest to J, and the two sizes in S are replaced by their geometric mean.
Frame RotationAndSize(const Slope& slope) {
  const double shear = glm::dot(slope.along_u, slope.along_v);
  // J^T J, symmetric, two by two.
  const glm::dmat2 square{glm::dot(slope.along_u, slope.along_u), shear,  //
                          shear, glm::dot(slope.along_v, slope.along_v)};
  if (Flat(square)) return {};
  const double area = std::sqrt(glm::determinant(square));
  const glm::dmat2 root =
      // The square root of a symmetric 2 x 2 matrix A: (A + sqrt(det A) I) / sqrt(trace A + 2 sqrt(det A)),
      // by the theorem of Cayley and Hamilton.
      (square + area * glm::dmat2(1.0)) / std::sqrt(square[0][0] + square[1][1] + 2 * area);
  // S^-1, times the geometric mean of the two sizes: sqrt(area) = sqrt(s1 s2).
  const glm::dmat2 unstretch = glm::inverse(root) * std::sqrt(area);
  const glm::dvec3 u = slope.along_u * unstretch[0][0] + slope.along_v * unstretch[0][1];
  const glm::dvec3 v = slope.along_u * unstretch[1][0] + slope.along_v * unstretch[1][1];
  return {glm::vec3(u), glm::vec3(v), glm::vec3(glm::cross(u, v) / std::sqrt(area))};
}

// Weighted least squares of the slope, about the point itself: nearer points count more.
Frame FitFrame(const ControlNet& net, std::span<const glm::vec3> on_face, std::size_t at) {
  Moments moments;
  const glm::dvec2 here = InMetres(net.points[at].uv);
  for (std::size_t i = 0; i < net.points.size(); ++i) {
    moments.Add(InMetres(net.points[i].uv) - here, glm::dvec3(on_face[i]) - glm::dvec3(on_face[at]));
  }
  if (Flat(moments.steps)) return {};
  return RotationAndSize(moments.Solve());
}

}  // namespace

// Rows sum to 1, so this is a point of the face.
std::vector<glm::vec3> PointsOnFace(const ControlNet& net, std::span<const glm::vec3> positions) {
  std::vector<glm::vec3> points(net.surface.rows());
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (auto i = net.surface.row_start[row]; i < net.surface.row_start[row + 1]; ++i) {
      points[row] += net.surface.weight[i] * positions[net.surface.column[i]];
    }
  }
  return points;
}

std::vector<Frame> FitFrames(const ControlNet& net, std::span<const glm::vec3> on_face) {
  std::vector<Frame> frames(net.points.size());
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = FitFrame(net, on_face, i);
  return frames;
}

std::vector<glm::vec3> Carry(const Expression& expression, std::span<const Frame> frames, float gain) {
  std::vector<glm::vec3> moved(frames.size());
  Carry(expression, frames, gain, moved);
  return moved;
}

// An expression's displacements are stored in the frame of the skin, along u, along v and outwards, so that
// they fit a face of another shape: each frame turns them into that face's own directions. Metres before and
// after.
void Carry(const Expression& expression, std::span<const Frame> frames, float gain,
           std::span<glm::vec3> moved) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const glm::vec3 d = gain * expression.displacement[i];
    moved[i] = d.x * frames[i].along_u + d.y * frames[i].along_v + d.z * frames[i].outwards;
  }
}

// By the frames of both faces at the same point.
std::vector<glm::mat3> Turns(std::span<const Frame> reference, std::span<const Frame> face) {
  std::vector<glm::mat3> turns;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const glm::mat3 from(reference[i].along_u, reference[i].along_v, reference[i].outwards);
    const glm::mat3 to(face[i].along_u, face[i].along_v, face[i].outwards);
    // Frames are a rotation times a size, so the inverse exists.
    turns.push_back(to * glm::inverse(from));
  }
  return turns;
}

// What the control net cannot say of an expression is added vertex by vertex, turned as the points about it
// turned.
void AddResidual(const ControlNet& net, const Expression& expression, std::span<const glm::mat3> turns,
                 float gain, std::span<glm::vec3> moved) {
  for (std::size_t row = 0; row < expression.residual.size(); ++row) {
    const glm::vec3 residual = gain * expression.residual[row];
    glm::vec3 turned{};
    float share = 0;
    for (auto i = net.to_cage.row_start[row]; i < net.to_cage.row_start[row + 1]; ++i) {
      turned += net.to_cage.weight[i] * (turns[net.to_cage.column[i]] * residual);
      share += net.to_cage.weight[i];
    }
    // Weights near the border sum to less than 1; the turn is their mean all the same. A vertex without
    // points is not turned.
    moved[row] += share > 0 ? turned / share : residual;
  }
}

}  // namespace kaori::face
