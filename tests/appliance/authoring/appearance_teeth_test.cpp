// Teeth and tongue are seen between the lips or not at all, whatever the face plays.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/cage.h"
#include "render/face/composer.h"
#include "tests/appliance/authoring/appearance_fixture.h"

namespace kaori::appearance {
namespace {

using face::Part;
using sculpt::Region;

constexpr float kShut_m = 0.0002F;  // Below this drop of the jaw nothing of the mouth's inside is drawn.
constexpr float kLipWidth_m =
    0.002F;                        // A tooth that shows this far outside the lips' edge is still behind them.
constexpr float kReach_m = 0.07F;  // Triangles further than this from the lips cannot cover a tooth.

float Presence(const face::MouthFit& fit, Part part) {
  if (part == Part::kUpperTeeth) return fit.upper_teeth;
  if (part == Part::kLowerTeeth) return fit.lower_teeth;
  return part == Part::kTongue ? fit.tongue : 0;
}

// As they are drawn: the lower teeth go down and back with the jaw, the tongue nearly so.
glm::vec3 JawMotion(Part part, float drop_m) {
  if (part == Part::kLowerTeeth) return {0, -drop_m, -0.25F * drop_m};
  if (part == Part::kTongue) return {0, -0.80F * drop_m, -0.20F * drop_m};
  return {};
}

// A direction of looking; z points to the audience.
glm::vec3 SeenFrom(float yaw_rad, glm::vec3 p) {
  const float c = std::cos(yaw_rad);
  const float s = std::sin(yaw_rad);
  return {c * p.x - s * p.z, p.y, s * p.x + c * p.z};
}

// Products of floats are exact in doubles: Cross(a, b) is -Cross(b, a) to the last bit, however a processor joins the operations, so that no
// point lies between two triangles.
double Cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

// The skin and the edge of the lips from one side.
class View {
 public:
  View(const sculpt::Cage& cage, const face::Topology& topology, const face::Shape& shape, float yaw_rad)
      : yaw_rad_(yaw_rad) {
    for (const glm::vec3& p : shape.cage) points_.push_back(SeenFrom(yaw_rad, p));
    const auto lip = [&](const std::vector<face::Index>& side, int j) {
      return glm::vec2(points_[side[cage.half.At(Region::kMouth, j, sculpt::kLipContactRing)]]);
    };
    for (int j = 0; j < sculpt::kMouthRim; ++j) edge_.push_back(lip(cage.left, j));
    for (int j = sculpt::kMouthRim - 1; j >= 0; --j) edge_.push_back(lip(cage.right, j));
    for (const glm::vec2 p : edge_) middle_ += p / static_cast<float>(edge_.size());
    for (const face::Triangle& t : topology.triangles) {
      if (glm::distance(glm::vec2(points_[t[0]]), middle_) < kReach_m) near_.push_back(t);
    }
  }

  bool Shows(glm::vec3 head) const {
    const glm::vec3 p = SeenFrom(yaw_rad_, head);
    return !IsBetweenLips(p) &&
           std::none_of(near_.begin(), near_.end(), [&](const auto& t) { return Covers(t, p); });
  }

 private:
  bool IsBetweenLips(glm::vec2 p) const {
    bool inside = false;
    for (std::size_t i = 0, j = edge_.size() - 1; i < edge_.size(); j = i++) {
      const glm::vec2 a = edge_[i], b = edge_[j];
      if (glm::distance(p, a) < kLipWidth_m) return true;
      if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
  }

  bool Covers(const face::Triangle& t, glm::vec3 p) const {
    const glm::vec3 &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    const double area = Cross(b - a, c - a);
    const double in_a = Cross(b - p, c - p) / area;
    const double in_b = Cross(c - p, a - p) / area;
    const double in_c = Cross(a - p, b - p) / area;
    if (!(in_a >= 0 && in_b >= 0 && in_c >= 0)) return false;
    return in_a * a.z + in_b * b.z + in_c * c.z > p.z;
  }

  float yaw_rad_;
  std::vector<glm::vec3> points_;
  std::vector<glm::vec2> edge_;
  glm::vec2 middle_{};
  std::vector<face::Triangle> near_;
};

int CountShowing(const View& view, const face::Shape& shape) {
  const face::Cast& cast = DressedCast();
  int count = 0;
  for (const face::Prop& prop : cast.props) {
    if (Presence(shape.mouth, prop.part) <= 0) continue;
    const glm::vec3 offset = shape.mouth.offset + JawMotion(prop.part, shape.jaw_drop_m) + cast.mouth_anchor;
    for (std::size_t i = 0; i < prop.vertices.size(); i += 3) {
      if (view.Shows((prop.vertices[i].position - cast.mouth_anchor) * shape.mouth.scale + offset)) ++count;
    }
  }
  return count;
}

TEST(AppearanceTeeth, ShowOnlyBetweenTheLipsInEveryExpressionOfEveryFace) {
  const sculpt::Cage cage = sculpt::BuildCage();
  const face::Cast& cast = DressedCast();
  face::Composer composer(cast);
  for (std::uint16_t f = 0; f < cast.faces.size(); ++f) {
    for (std::uint16_t e = 0; e < cast.expressions.size(); ++e) {
      face::Weights weights;
      weights.faces.Push(f, 1);
      weights.expressions.Push(e, 1);
      const face::Shape& shape = composer.Compose(weights, face::Detail::kCage);
      if (shape.jaw_drop_m < kShut_m) continue;
      for (const float yaw_rad : {-0.6F, 0.0F, 0.6F}) {
        const View view(cage, cast.topology, shape, yaw_rad);
        EXPECT_EQ(CountShowing(view, shape), 0)
            << cast.faces[f].name << " " << cast.expressions[e].name << " from " << yaw_rad << " rad";
      }
    }
  }
}

const face::Prop& UpperTeeth() {
  return *std::ranges::find(DressedCast().props, Part::kUpperTeeth, &face::Prop::part);
}

// From half a radian the teeth of the far side are seen for 9 mm beside the middle: else the mouth is a black hole there.
TEST(AppearanceTeeth, OfTheFarSideAreSeenWhenTheHeadIsTurned) {
  float front_m = -1, middle_m = 0, far_m = 1;
  for (const face::PropVertex& v : UpperTeeth().vertices) {
    const glm::vec3 seen = SeenFrom(0.5F, v.position);
    far_m = std::min(far_m, seen.x);
    if (v.position.z > front_m) {
      front_m = v.position.z;
      middle_m = seen.x;
    }
  }
  EXPECT_GT(middle_m - far_m, 0.0085F);
}

TEST(AppearanceTeeth, EndInTheDarkOfTheMouthAtBothSides) {
  float widest_m = 0;
  for (const face::PropVertex& v : UpperTeeth().vertices) widest_m = std::max(widest_m, v.position.x);
  for (const face::PropVertex& v : UpperTeeth().vertices) {
    if (std::abs(v.position.x) > 0.9F * widest_m) {
      EXPECT_LT(v.shade, 0.25F) << v.position.x;
    }
  }
}

TEST(AppearanceTeeth, WouldBeSeenIfTheyStoodBeforeTheLips) {
  const sculpt::Cage cage = sculpt::BuildCage();
  const face::Cast& cast = DressedCast();
  face::Composer composer(cast);
  face::Shape shape = composer.Compose({}, face::Detail::kCage);
  shape.mouth.offset = {0, -0.01F, 0.02F};
  EXPECT_GT(CountShowing(View(cage, cast.topology, shape, 0), shape), 20);
}

}  // namespace
}  // namespace kaori::appearance
