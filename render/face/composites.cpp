#include "render/face/composites.h"

#include <algorithm>
#include <cstring>

#include "render/face/frame.h"
#include "render/face/sparse.h"

namespace kaori::face {
namespace {

constexpr const char* kJawPoint = "LC";  // The middle of the lower lip's contact line.

// One float of slack behind the last vertex, see ApplyToVertices.
std::size_t VertexFloats(Index vertices) {
  return Padded(3 * std::size_t{vertices} + 1);
}

bool MovesSomething(const Expression& expression) {
  const auto moves = [](const glm::vec3& d) { return d != glm::vec3{}; };
  return std::ranges::any_of(expression.displacement, moves) ||
         std::ranges::any_of(expression.residual, moves);
}

float MeanAt(const SparseRows& rows, std::size_t row, std::span<const float> values) {
  float sum = 0;
  for (auto i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i)
    sum += rows.weight[i] * values[rows.column[i]];
  return sum;
}

}  // namespace

Composites::Composites(const Cast& cast)
    : faces_(cast.faces.size()),
      expressions_(cast.expressions.size()),
      face_floats_(VertexFloats(cast.topology.vertex_count)),
      moving_floats_(VertexFloats(cast.topology.moving_count)),
      bases_(faces_ * face_floats_),
      jaw_drops_m_(faces_ * expressions_, 0.0F) {
  CopyBases(cast);
  NumberMoving(cast);
  FindJaw(cast);
  displacements_ = AlignedFloats(faces_ * slots_ * moving_floats_);
  for (std::size_t face = 0; face < faces_; ++face) ComposeFace(cast, face);
}

const float* Composites::displacement(std::size_t face, std::size_t expression) const {
  if (!slot_[expression]) return nullptr;
  return displacements_.data() + (face * slots_ + *slot_[expression]) * moving_floats_;
}

void Composites::CopyBases(const Cast& cast) {
  for (std::size_t i = 0; i < faces_; ++i) {
    const auto& positions = cast.faces[i].positions;
    std::memcpy(bases_.data() + i * face_floats_, positions.data(), positions.size() * sizeof positions[0]);
  }
}

void Composites::NumberMoving(const Cast& cast) {
  for (const Expression& expression : cast.expressions) {
    slot_.push_back(MovesSomething(expression) ? std::optional(slots_++) : std::nullopt);
  }
}

void Composites::FindJaw(const Cast& cast) {
  const auto& points = cast.net.points;
  const auto jaw = std::ranges::find(points, kJawPoint, &ControlPoint::name);
  if (jaw == points.end()) return;
  jaw_point_ = static_cast<std::size_t>(jaw - points.begin());
  if (cast.topology.mouth_share.empty()) return;
  jaw_mouth_share_ = MeanAt(cast.net.surface, *jaw_point_, cast.topology.mouth_share);
}

void Composites::ComposeFace(const Cast& cast, std::size_t face) {
  const Face& shape = cast.faces[face];
  const auto frames = FitFrames(cast.net, PointsOnFace(cast.net, shape.positions));
  const auto reference = FitFrames(cast.net, PointsOnFace(cast.net, cast.faces.front().positions));
  const auto turns = Turns(reference, frames);
  AlignedFloats moved(3 * frames.size());
  for (std::size_t j = 0; j < expressions_; ++j) {
    if (!slot_[j]) continue;
    const auto vectors = Carry(cast.expressions[j], frames, shape.expression_gain);
    std::ranges::copy(vectors, moved.vertices(vectors.size()).begin());
    float* out = displacements_.data() + (face * slots_ + *slot_[j]) * moving_floats_;
    ApplyToVertices(cast.net.to_cage, moved.data(), out);
    AddResidual(cast.net, cast.expressions[j], turns, shape.expression_gain,
                {reinterpret_cast<glm::vec3*>(out), cast.topology.moving_count});
    out[3 * std::size_t{cast.topology.moving_count}] = 0;  // The slack: the first vertex that does not move.
    if (jaw_point_) jaw_drops_m_[face * expressions_ + j] = -vectors[*jaw_point_].y;
  }
}

}  // namespace kaori::face
