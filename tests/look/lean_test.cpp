// The head leans in, turns and bows: the neck must stay in its collar.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "render/face/composer.h"
#include "render/passes/dressing.h"
#include "render/passes/frame.h"
#include "tests/look/look_pack.h"
#include "tests/look/report.h"

namespace kaori {
namespace {

constexpr float kFarthestLean_m = 0.12F;  // As the stick's slider.
// As far as the stick turns the head, and with the motion "bow" on top.
constexpr float kFarthestYaw_rad = 0.62F, kFarthestUp_rad = 0.40F, kDeepestBow_rad = -0.85F;
constexpr float kTouching_m = 0.0005F;

// What is seen of a point: where in the picture, and how far from the camera.
struct Seen {
  glm::vec2 at{};
  float distance_m = 0;
};

Seen SeenAt(const passes::FrameBlock& frame, glm::vec3 placed) {
  const glm::vec4 in_camera = frame.view * glm::vec4(placed, 1);
  const glm::vec4 clip = frame.projection * in_camera;
  return {glm::vec2(clip) / clip.w, -in_camera.z};
}

struct SeenTriangle {
  std::array<Seen, 3> corners;

  // How far from the camera the triangle is at this place of the picture; below 0 where it does not lie there.
  float DistanceAt(glm::vec2 at) const {
    const auto cross = [](glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; };
    const glm::vec2 a = corners[0].at;
    const float whole = cross(corners[1].at - a, corners[2].at - a);
    if (std::abs(whole) < 1e-12F) return -1;
    const float v = cross(at - a, corners[2].at - a) / whole;
    const float w = cross(corners[1].at - a, at - a) / whole;
    if (v < 0 || w < 0 || v + w > 1) return -1;
    return (1 - v - w) * corners[0].distance_m + v * corners[1].distance_m + w * corners[2].distance_m;
  }
};

// One face and its clothes, with its head held so.
class Held {
 public:
  Held(const face::Cast& cast, std::size_t face, const face::Shape& shape, const scene::Head& head)
      : shape_(shape), frame_(FrameOf(cast, shape.faces, head)) {
    for (const int index : cast.faces[face].props) AddFront(cast.props[static_cast<std::size_t>(index)]);
  }

  // Vertices of the neck's front that are nearer to the camera than the nearest cloth before which they lie.
  int Crossings() const {
    int crossings = 0;
    for (std::size_t i = 0; i < shape_.fine.size(); ++i) {
      if (!IsNeck(shape_.fine[i]) || shape_.fine_normals[i].z < 0.2F) continue;
      const Seen seen = SeenAt(frame_, PlacedNeck(shape_.fine[i]));
      const float cloth_m = NearestCloth_m(seen.at);
      if (cloth_m > 0 && seen.distance_m < cloth_m - kTouching_m) ++crossings;
    }
    return crossings;
  }
  std::size_t cloth() const { return cloth_.size(); }

 private:
  // As the painter's.
  static passes::FrameBlock FrameOf(const face::Cast& cast, const face::Terms& faces,
                                    const scene::Head& head) {
    scene::Scene scene;
    scene.head = head;
    const passes::Dressing dressing = passes::Necks(cast).Dress(faces);
    const passes::Neck neck = passes::NeckOf(cast);
    const passes::Neck worn = dressing.count > 0 ? AboveCollar(neck, dressing.collar_m) : neck;
    return passes::MakeFrame(scene, worn, {960, 540}, 1);
  }

  // As TurnShare of frame.glsl.
  float TurnShare(glm::vec3 p) const {
    const float height_m = p.y + 0.8F * std::max(p.z - frame_.pivot.z - 0.04F, 0.0F);
    return glm::smoothstep(frame_.pivot.w, frame_.shift.w, height_m);
  }
  // What does not turn wholly with the head.
  bool IsNeck(glm::vec3 p) const { return TurnShare(p) < 0.9F; }

  // As HeadToCamera of frame.glsl, without breath.
  glm::vec3 PlacedNeck(glm::vec3 p) const {
    const float share = TurnShare(p);
    const glm::vec4 part = glm::normalize(glm::mix(glm::vec4(0, 0, 0, 1), frame_.turn, share));
    const glm::vec3 pivot(frame_.pivot);
    glm::vec3 turned = glm::quat(part.w, part.x, part.y, part.z) * (p - pivot) + pivot;
    const float bend = glm::smoothstep(0.62F, 1.0F, share);
    turned.x = glm::mix(p.x, turned.x, bend);
    turned.z = glm::mix(p.z, turned.z, bend);
    return turned + LeanShare(frame_, p.y) * glm::vec3(frame_.shift);
  }

  // The back of a collar stands behind the neck: only what looks forward, before the neck's middle, hides it.
  void AddFront(const face::Prop& prop) {
    if (prop.part != face::Part::kClothes) return;
    for (const face::Triangle& t : prop.triangles) {
      const auto looks_forward = [&](face::Index i) {
        return prop.vertices[i].normal.z > 0 && prop.vertices[i].position.z > frame_.pivot.z - 0.01F;
      };
      if (!std::ranges::all_of(t, looks_forward)) continue;
      SeenTriangle seen;
      for (std::size_t c = 0; c < 3; ++c) {
        const glm::vec3 p = prop.vertices[t[c]].position;
        seen.corners[c] = SeenAt(frame_, Placed(frame_, p, passes::Follows::kBody));
      }
      cloth_.push_back(seen);
    }
  }

  float NearestCloth_m(glm::vec2 at) const {
    float nearest_m = -1;
    for (const SeenTriangle& t : cloth_) {
      const float distance_m = t.DistanceAt(at);
      if (distance_m > 0 && (nearest_m < 0 || distance_m < nearest_m)) nearest_m = distance_m;
    }
    return nearest_m;
  }

  const face::Shape& shape_;
  passes::FrameBlock frame_;
  std::vector<SeenTriangle> cloth_;
};

// How often a neck of the ten comes through its collar in these poses.
int CrossingsIn(std::span<const scene::Head> poses) {
  const face::Cast cast = tests::ClothedCast();
  face::Composer composer(cast);
  int crossings = 0;
  for (std::uint16_t face = 0; face < cast.faces.size(); ++face) {
    face::Weights weights;
    weights.faces.Push(face, 1);
    weights.expressions.Push(0, 1);
    const face::Shape& shape = composer.Compose(weights, face::Detail::kFine);
    for (const scene::Head& head : poses) {
      const Held held(cast, face, shape, head);
      const int here = held.Crossings();
      EXPECT_EQ(here, 0) << cast.faces[face].name << " leaning in by " << head.shift_m.z << " m, turned by "
                         << head.yaw_rad << ", looking up by " << head.pitch_rad;
      crossings += here;
      if (cast.faces[face].name != "kettle") {
        EXPECT_GT(held.cloth(), 100U) << cast.faces[face].name;
      }
    }
  }
  return crossings;
}

// Ten faces, from upright to leaning in wholly.
TEST(Lean, TakesNoNeckThroughItsCollar) {
  std::vector<scene::Head> poses;
  for (int step = 0; step <= 6; ++step)
    poses.push_back({.shift_m = {0, 0, kFarthestLean_m * static_cast<float>(step) / 6}});
  tests::Report("lean_collar_crossings", CrossingsIn(poses));
}

TEST(TurningAndBowing, TakesNoNeckThroughItsCollar) {
  std::vector<scene::Head> poses;
  for (const float yaw_rad : {-kFarthestYaw_rad, 0.0F, kFarthestYaw_rad}) {
    for (const float pitch_rad : {kDeepestBow_rad, kDeepestBow_rad / 2, 0.0F, kFarthestUp_rad})
      poses.push_back({.yaw_rad = yaw_rad, .pitch_rad = pitch_rad});
  }
  tests::Report("turn_collar_crossings", CrossingsIn(poses));
}

}  // namespace
}  // namespace kaori
