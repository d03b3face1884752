#include "render/face/composites.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "render/face/sparse.h"

namespace kaori::face {
namespace {

// The middle of the lower lip's contact line.
constexpr const char* kJawPoint = "LC";

// One float of slack behind the last vertex, see ApplyToVertices.
std::size_t VertexFloats(Index vertices) {
  return Padded(3 * std::size_t{vertices} + 1);
}

// Neutral moves nothing, and gets no array.
bool MovesSomething(const Expression& expression) {
  const auto moves = [](const glm::vec3& d) { return d != glm::vec3{}; };
  return std::ranges::any_of(expression.displacement, moves) ||
         std::ranges::any_of(expression.residual, moves);
}

// One row of a matrix applied to numbers.
float MeanAt(const SparseRows& rows, std::size_t row, std::span<const float> values) {
  float sum = 0;
  for (auto i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i)
    sum += rows.weight[i] * values[rows.column[i]];
  return sum;
}

}  // namespace

// Works out every pair of a face and an expression, so that a frame only adds them up.
Composites::Composites(const Cast& cast)
    : faces_(cast.faces.size()),
      expressions_(cast.expressions.size()),
      face_floats_(VertexFloats(cast.topology.vertex_count)),
      moving_floats_(VertexFloats(cast.topology.moving_count)),
      bases_(faces_ * face_floats_),
      displacements_(expressions_),
      outdated_(faces_ * expressions_, 0),
      moved_(3 * cast.net.points.size()),
      jaw_drops_m_(faces_ * expressions_, 0.0F) {
  CopyBases(cast);
  FindJaw(cast);
  FitFaces(cast);
  // Marks all, then works them out: the same way as later, when one has changed.
  for (std::size_t j = 0; j < expressions_; ++j) Outdate(cast, j);
  for (std::size_t face = 0; face < faces_; ++face)
    for (std::size_t j = 0; j < expressions_; ++j) Refresh(cast, face, j);
}

// The array of an expression that moved nothing so far is made here, which is the one allocation.
void Composites::Outdate(const Cast& cast, std::size_t expression) {
  AlignedFloats& faces = displacements_[expression];
  if (faces.size() == 0 && !MovesSomething(cast.expressions[expression])) return;
  if (faces.size() == 0) faces = AlignedFloats(faces_ * moving_floats_);
  for (std::size_t face = 0; face < faces_; ++face) outdated_[face * expressions_ + expression] = 1;
}

// A byte a face and expression says whether there is anything to do.
void Composites::Refresh(const Cast& cast, std::size_t face, std::size_t expression) {
  std::uint8_t& outdated = outdated_[face * expressions_ + expression];
  if (outdated == 0) return;
  ComposeFace(cast, face, expression);
  outdated = 0;
}

std::size_t Composites::bytes() const {
  std::size_t floats = bases_.size();
  for (const AlignedFloats& faces : displacements_) floats += faces.size();
  return floats * sizeof(float);
}

void Composites::CopyBases(const Cast& cast) {
  for (std::size_t i = 0; i < faces_; ++i) {
    const auto& positions = cast.faces[i].positions;
    // Slack and padding stay zero.
    std::memcpy(bases_.data() + i * face_floats_, positions.data(), positions.size() * sizeof positions[0]);
  }
}

// How far the jaw drops is read off one control point. A cast without it has no drop, and its mouth stays
// dark.
void Composites::FindJaw(const Cast& cast) {
  const auto& points = cast.net.points;
  const auto jaw = std::ranges::find(points, kJawPoint, &ControlPoint::name);
  if (jaw == points.end()) return;
  jaw_point_ = static_cast<std::size_t>(jaw - points.begin());
  if (cast.topology.mouth_share.empty()) return;
  jaw_mouth_share_ = MeanAt(cast.net.surface, *jaw_point_, cast.topology.mouth_share);
}

// Frames need a face's positions alone, so each is fitted once for all expressions.
void Composites::FitFaces(const Cast& cast) {
  const auto reference = FitFrames(cast.net, PointsOnFace(cast.net, cast.faces.front().positions));
  for (const Face& face : cast.faces) {
    auto frames = FitFrames(cast.net, PointsOnFace(cast.net, face.positions));
    auto turns = Turns(reference, frames);
    carriers_.push_back({std::move(frames), std::move(turns)});
  }
}

// E_ij: the control points moved as the face carries them, spread over the mesh, and what the artist's shape
// has besides.
void Composites::ComposeFace(const Cast& cast, std::size_t face, std::size_t j) {
  const float gain = cast.faces[face].expression_gain;
  const std::span<glm::vec3> moved = moved_.vertices(cast.net.points.size());
  Carry(cast.expressions[j], carriers_[face].frames, gain, moved);
  float* out = displacements_[j].data() + face * moving_floats_;
  ApplyToVertices(cast.net.to_cage, moved_.data(), out);
  AddResidual(cast.net, cast.expressions[j], carriers_[face].turns, gain,
              {reinterpret_cast<glm::vec3*>(out), cast.topology.moving_count});
  out[3 * std::size_t{cast.topology.moving_count}] = 0;  // The slack: the first vertex that does not move.
  if (jaw_point_) jaw_drops_m_[face * expressions_ + j] = -moved[*jaw_point_].y;
}

}  // namespace kaori::face
