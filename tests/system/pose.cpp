#include "tests/system/pose.h"

#include <cmath>

#include <fmt/format.h>

#include "appliance/core/board/performance_state.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"

namespace kaori::test {
namespace {

constexpr float kAxis = 1e-6F;
constexpr float kMouth = 0.05F;  // The camera's noise.
constexpr float kKnob = 1e-3F;
constexpr float kHead_rad = 0.01F;

class Differences {
 public:
  template <std::size_t kSize>
  void Floats(const char* name, const std::array<float, kSize>& a, const std::array<float, kSize>& b,
              float most) {
    for (std::size_t i = 0; i < kSize; ++i)
      if (!(std::abs(a[i] - b[i]) <= most))
        text_ += fmt::format("{} {}: {} is now {}; ", name, i, a[i], b[i]);
  }

  template <class T, std::size_t kSize>
  void Numbers(const char* name, const std::array<T, kSize>& a, const std::array<T, kSize>& b) {
    for (std::size_t i = 0; i < kSize; ++i)
      if (a[i] != b[i]) text_ += fmt::format("{} {}: {} is now {}; ", name, i, a[i], b[i]);
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

Pose PoseOn(const board::Board& board) {
  const board::Snapshot all = board::ReadAll(board);
  Pose pose{
      .counts = all.surface.value.counts,
      .pushes = all.surface.value.pushes,
      .keys_down = all.keys.value.down,
      .key_pushes = all.keys.value.pushes,
      .axes = {all.sticks[0].value.x, all.sticks[0].value.y, all.sticks[1].value.x, all.sticks[1].value.y},
      .mouth = {all.lips.value.height, all.lips.value.width}};
  if (const auto state = board::Restore<performance::State>(board.Read<board::Performance>().value)) {
    pose.knobs = state->shown;
    pose.called = {state->faces.to, state->expressions.to, state->styles.to, state->scene};
    pose.head_yaw_rad = state->head.yaw_rad;
    pose.head_pitch_rad = state->head.pitch_rad;
  }
  return pose;
}

std::string Differs(const Pose& before, const Pose& now) {
  Differences differences;
  differences.Numbers("dial", before.counts, now.counts);
  differences.Numbers("pushes of button", before.pushes, now.pushes);
  differences.Numbers("word of keys", before.keys_down, now.keys_down);
  differences.Numbers("pushes of key", before.key_pushes, now.key_pushes);
  differences.Floats("axis", before.axes, now.axes, kAxis);
  differences.Floats("mouth", before.mouth, now.mouth, kMouth);
  differences.Floats("knob", before.knobs, now.knobs, kKnob);
  differences.Numbers("called", before.called, now.called);
  differences.Floats("head", std::array{before.head_yaw_rad, before.head_pitch_rad},
                     std::array{now.head_yaw_rad, now.head_pitch_rad}, kHead_rad);
  return differences.text();
}

}  // namespace kaori::test
