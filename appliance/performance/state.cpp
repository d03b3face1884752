#include "appliance/performance/state.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace kaori::performance {
namespace {

constexpr float kFar = 1e3F;  // No field of a sound state is larger.

bool Within(std::initializer_list<float> values) {
  return std::ranges::all_of(values, [](float v) { return std::abs(v) < kFar; });  // False for NaN too.
}

bool SoundMixture(const Mixture& mixture, std::size_t count) {
  const bool exists = mixture.to < count && mixture.from.size() >= 0 &&
                      mixture.from.size() <= face::Terms::kCapacity &&
                      std::ranges::all_of(mixture.from, [count](const face::Term& t) {
                        return t.index < count && Within({t.weight});
                      });
  const bool whole = mixture.from.empty() || std::abs(mixture.from.sum() - 1) < 1e-2F;
  return exists && whole && Within({mixture.progress, mixture.duration_s});
}

bool SoundVectors(const State& s) {
  const auto& b = s.backstage;
  const auto vec = [](const glm::vec3& v) { return Within({v.x, v.y, v.z}); };
  return vec(b.backdrop_from.top) && vec(b.backdrop_from.bottom) && vec(b.backdrop_to.top) &&
         vec(b.backdrop_to.bottom) && vec(s.head.shift_m) &&
         Within({b.exposure_from, b.exposure_to, b.progress, b.duration_s}) &&
         Within({s.sway.angle_rad.x, s.sway.angle_rad.y, s.sway.speed_rad_s.x, s.sway.speed_rad_s.y,
                 s.sway.head_rad.x, s.sway.head_rad.y, s.life.glance_rad.x, s.life.glance_rad.y});
}

bool SoundScalars(const State& s) {
  const auto each = [](const auto& list) { return std::ranges::all_of(list, [](float v) { return Within({v}); }); };
  return s.age_s >= 0 && std::isfinite(s.age_s) && each(s.knobs) && each(s.shown) && each(s.blink_s) &&
         each(s.lids_held) && std::ranges::all_of(s.sticks, [](const StickNow& n) { return Within({n.presence}); }) &&
         Within({s.head.yaw_rad, s.head.pitch_rad, s.head.roll_rad, s.gaze.yaw_rad, s.gaze.pitch_rad, s.brow,
                 s.mouth_open, s.mouth_wide, s.mouth_drive, s.mouth_quiet_s, s.life.to_next_blink_s,
                 s.life.to_next_glance_s});
}

}  // namespace

bool Sound(const State& state, const show::Show& show) {
  const bool takes = std::ranges::all_of(state.voices, [&show](const Playing& v) {
    return v.take < static_cast<int>(show.takes.size()) && Within({v.at_s, v.gain});
  });
  return takes && SoundMixture(state.faces, show.cast.faces.size()) &&
         SoundMixture(state.expressions, show.cast.expressions.size()) &&
         SoundMixture(state.styles, scene::kStyleCount) && SoundVectors(state) && SoundScalars(state) &&
         (show.scenes.empty() || state.scene < show.scenes.size());
}

}  // namespace kaori::performance
