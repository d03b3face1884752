#include "appliance/programs/editor/handle_picker.h"

#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace kaori::editor {
namespace {

constexpr float kMeant = 0.1F;     // A press further away than this part of the half height means no handle.
constexpr float kAside = 2;        // A handle this much aside of a direction is as far as one straight ahead.
constexpr float kWidest = 1.2F;    // Tangent of the angle within which a handle lies "in that direction".
constexpr float kHead_m = 0.008F;  // As far as a handle stands out of the skin (render/passes/handles).
constexpr float kLeastFlat = 1e-9F;  // A carrier with less volume than this turns no way into a pull.

// One row of a sparse matrix times the values: where a control point lies on the face as it was drawn.
glm::vec3 MeanAt(const face::SparseRows& rows, std::size_t row, std::span<const glm::vec3> values) {
  glm::vec3 sum{};
  for (auto i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i)
    sum += rows.weight[i] * values[rows.column[i]];
  return sum;
}

// From a position to the line between two.
float Away(glm::vec2 position, glm::vec2 root, glm::vec2 head) {
  const glm::vec2 line = head - root;
  const float square = glm::dot(line, line);
  const float along = square > 0 ? glm::clamp(glm::dot(position - root, line) / square, 0.0F, 1.0F) : 0.0F;
  return glm::length(position - (root + along * line));
}

}  // namespace

// The frames carry a pull from the parameter space to each face (face::FitFrames); a face's gain scales it.
HandlePicker::HandlePicker(const face::Cast& cast) : handles_(cast.net.points.size()) {
  for (const face::Face& face : cast.faces) {
    frames_.push_back(face::FitFrames(cast.net, face::PointsOnFace(cast.net, face.positions)));
    gains_.push_back(face.expression_gain);
  }
}

// Positions are scaled by the aspect, so that distances in the picture are the same in both directions. A
// handle whose root faces away from the camera is not seen and cannot be chosen.
void HandlePicker::Look(const face::Cast& cast, const face::Shape& shape, const scene::Scene& scene,
                        float aspect) {
  view_.emplace(scene, cast.neck_pivot, aspect);
  aspect_ = aspect;
  faces_ = shape.faces;
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    Handle& handle = handles_[i];
    handle.root_m = MeanAt(cast.net.surface, i, shape.cage);
    handle.at = view_->InPicture(handle.root_m) * glm::vec2(aspect, 1);
    const glm::vec3 normal = MeanAt(cast.net.surface, i, shape.cage_normals);
    handle.head = view_->InPicture(handle.root_m + normal * kHead_m) * glm::vec2(aspect, 1);
    handle.seen = view_->Faces(handle.root_m, normal);
  }
}

// The whole handle counts, from its root to its head.
std::optional<std::size_t> HandlePicker::Nearest(glm::vec2 position) const {
  const glm::vec2 at = glm::vec2(position.x * 2 - 1, 1 - position.y * 2) * glm::vec2(aspect_, 1);
  std::optional<std::size_t> nearest;
  float least = kMeant;
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    const float away = Away(at, handles_[i].at, handles_[i].head);
    if (!handles_[i].seen || !(away < least)) continue;
    least = away;
    nearest = i;
  }
  return nearest;
}

// The cost of a handle is how far ahead it lies plus kAside times how far aside; those outside of a cone of
// 50 degrees to each side do not lie in that direction.
std::optional<std::size_t> HandlePicker::Next(std::size_t from, glm::vec2 direction) const {
  const float length = glm::length(direction);
  if (from >= handles_.size() || !(length > 0)) return std::nullopt;
  const glm::vec2 ahead = direction / length;
  std::optional<std::size_t> next;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    const glm::vec2 way = handles_[i].at - handles_[from].at;
    const float along = glm::dot(way, ahead);
    const float aside = std::abs(way.x * ahead.y - way.y * ahead.x);
    const float cost = along + kAside * aside;
    if (i == from || !handles_[i].seen || !(along > 0) || aside > kWidest * along || !(cost < least))
      continue;
    least = cost;
    next = i;
  }
  return next;
}

// The way in metres, in the plane of the picture at the handle's depth, is taken back through the carrier of
// the faces that are shown: pull = carrier^-1 way. A carrier that is flat (a face of no size there) gives no
// pull.
glm::vec3 HandlePicker::PullAlong(std::size_t handle, glm::vec2 step) const {
  if (!view_ || handle >= handles_.size()) return {};
  const glm::vec3 way_m = view_->AtDepthOf(handles_[handle].root_m, {2 * step.x, -2 * step.y});
  const glm::mat3 carrier = CarrierOf(handle);
  if (!(std::abs(glm::determinant(carrier)) > kLeastFlat)) return {};
  return glm::inverse(carrier) * way_m;
}

glm::vec2 HandlePicker::position(std::size_t handle) const {
  const glm::vec2 at = handles_[handle].at / glm::vec2(aspect_, 1);
  return {(at.x + 1) / 2, (1 - at.y) / 2};
}

// What takes a pull to a way of the face that was seen: see face::Carry. Of several faces in a fade it is
// their weighted mean, since pulls are weighted the same way.
glm::mat3 HandlePicker::CarrierOf(std::size_t handle) const {
  glm::mat3 carrier(0.0F);
  for (const face::Term& face : faces_) {
    if (face.index >= frames_.size()) continue;
    const face::Frame& frame = frames_[face.index][handle];
    carrier += face.weight * gains_[face.index] * glm::mat3(frame.along_u, frame.along_v, frame.outwards);
  }
  return carrier;
}

}  // namespace kaori::editor
