#include "appliance/core/performance/aim.h"

#include <cmath>

#include <glm/common.hpp>

#include "render/face/mix.h"
#include "render/scene/view.h"

namespace kaori::performance {
namespace {

// Left and right, 63 mm apart, in the cast's frame: x to the character's left, z to the audience.
constexpr std::array<glm::vec3, 2> kUsualEyes_m{{{0.0315F, 0, 0.052F}, {-0.0315F, 0, 0.052F}}};
// Balls nearer to each other are none.
constexpr float kLeastApart_m = 0.02F;

}  // namespace

// atan2 gives 0 where both of its arguments are 0: a point in the eye itself is straight
// ahead, and nothing is divided.
glm::vec2 AnglesOf(glm::vec3 direction) {
  return {std::atan2(direction.x, direction.z),
          std::atan2(direction.y, std::hypot(direction.x, direction.z))};
}

glm::vec3 DirectionOf(glm::vec2 angles_rad) {
  const float level = std::cos(angles_rad.y);
  return {std::sin(angles_rad.x) * level, std::sin(angles_rad.y), std::cos(angles_rad.x) * level};
}

// Faces that a toggle keeps count as they do in the picture, so that she looks from where her eyes are seen.
std::array<glm::vec3, 2> EyesAtRest(const State& state, const show::Show& show) {
  face::Weights weights;
  weights.faces =
      WithKept(state, show, show::CallKind::kFace, Current(state.faces, At(state.shown, Knob::kFace)));
  const std::array<face::EyeBall, 2> balls = face::MixEyes(show.cast.faces, weights);
  if (balls[0].centre.x - balls[1].centre.x < kLeastApart_m) return kUsualEyes_m;
  return {balls[0].centre, balls[1].centre};
}

// The head turns about the neck and is shifted afterwards, as scene.h has it: the turn does not turn the
// shift.
HeadPose::HeadPose(const scene::Head& head, const std::array<glm::vec3, 2>& eyes_m, glm::vec3 pivot_m)
    : turn_(scene::TurnOf(head)), eyes_m_{} {
  for (std::size_t eye = 0; eye < 2; ++eye)
    eyes_m_[eye] = turn_ * (eyes_m[eye] - pivot_m) + pivot_m + head.shift_m;
  middle_m_ = (eyes_m_[0] + eyes_m_[1]) * 0.5F;
}

glm::vec2 HeadPose::EyeTo(std::size_t eye, glm::vec3 point_m) const {
  return InHead(point_m - eyes_m_[eye]);
}

glm::vec2 HeadPose::MiddleTo(glm::vec3 point_m) const {
  return InHead(point_m - middle_m_);
}

glm::vec3 HeadPose::Ahead(float distance_m) const {
  return middle_m_ + turn_ * glm::vec3(0, 0, distance_m);
}

// By directions and not by the difference of angles, which means less the farther up the eyes look.
float LooksPast_rad(const HeadPose& pose, const std::array<scene::Gaze, 2>& gaze, glm::vec3 point_m) {
  float most = 0;
  for (std::size_t eye = 0; eye < gaze.size(); ++eye) {
    const glm::vec3 looks = DirectionOf({gaze[eye].yaw_rad, gaze[eye].pitch_rad});
    const float cosine = glm::dot(looks, DirectionOf(pose.EyeTo(eye, point_m)));
    most = std::max(most, std::acos(std::clamp(cosine, -1.0F, 1.0F)));
  }
  return most;
}

}  // namespace kaori::performance
