// Nobody sees her life begin anew.
#include <array>

#include "tests/appliance/core/life_fixture.h"

namespace kaori::performance {
namespace {

using LifeInTime = LifeTest;

constexpr int kLooks_hz = 5;
// An audience that saw her do the same for so long would notice.
constexpr int kNoticed_s = 20;
constexpr int kFor_s = 1500;
// What differs by less is the same to an audience, degrees.
constexpr float kAlike_deg = 0.5F;

// Where her head is turned and where her eyes look, degrees.
using Pose = std::array<float, 5>;

Pose PoseOf(const scene::Scene& scene) {
  return {Degrees(scene.head.yaw_rad), Degrees(scene.head.pitch_rad), Degrees(scene.head.roll_rad),
          Degrees(scene.gaze[0].yaw_rad), Degrees(scene.gaze[0].pitch_rad)};
}

bool Alike(const Pose& a, const Pose& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > kAlike_deg) return false;
  return true;
}

// The shortest time after which she did for kNoticed_s what she had done before; the longest that was looked at
// where she never did. `never`: she did not. At least 2 s, for she may rest for so long.
struct Repeat {
  double after_s = 0;
  bool never = true;
};

Repeat ShortestRepeat(const std::vector<Pose>& poses) {
  const std::size_t window = std::size_t{kNoticed_s} * kLooks_hz;
  const std::size_t longest = poses.size() - window;
  for (std::size_t lag = std::size_t{2} * kLooks_hz; lag <= longest; ++lag) {
    std::size_t alike = 0;
    for (std::size_t n = 0; n + lag < poses.size(); ++n) {
      alike = Alike(poses[n], poses[n + lag]) ? alike + 1 : 0;
      if (alike >= window) return {static_cast<double>(lag) / kLooks_hz, false};
    }
  }
  return {static_cast<double>(longest) / kLooks_hz, true};
}

TEST_F(LifeInTime, DoesNotRepeatItselfInTenMinutes) {
  std::vector<Pose> poses;
  for (int n = 0; n < kFor_s * kLooks_hz; ++n) {
    for (int frame = 0; frame < 60 / kLooks_hz; ++frame) Frame();
    poses.push_back(PoseOf(performed_.scene));
  }
  const Repeat repeat = ShortestRepeat(poses);
  EXPECT_GE(repeat.after_s, 600);
  RecordProperty("life_repeat_s", std::to_string(repeat.after_s));
  // The control: of a life that does begin anew the repeat is found.
  const std::size_t period = std::size_t{431} * kLooks_hz;
  for (std::size_t n = period; n < poses.size(); ++n) poses[n] = poses[n - period];
  const Repeat found = ShortestRepeat(poses);
  EXPECT_FALSE(found.never);
  EXPECT_EQ(found.after_s, 431);
}

}  // namespace
}  // namespace kaori::performance
