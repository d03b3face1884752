#include "appliance/authoring/report/take.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/performance/ease.h"
#include "appliance/core/showlog/replay.h"

namespace kaori::authoring {
namespace {

using performance::Mix;
using performance::SmoothStep;
using show::MotionCurve;
using show::MotionKey;
using show::MotionTarget;

constexpr float kDegreesPerRad = 180 / std::numbers::pi_v<float>;
// Less than this is the noise of a stick that nobody holds.
// Radians, or a weight.
constexpr float kMoves = 1e-3F;

using Keys = std::vector<MotionKey>;

// What one frame adds to the curves, in their order.
struct Sample {
  float at_s = 0;
  std::array<float, 7> values{};  // Head yaw, pitch, roll; gaze yaw, pitch; brows up, frown.
};

// A brow has two curves, one for each way, since a channel only goes from 0 to 1.
// The state has what operators moved, without life and motions on top of it: those play again by themselves.
Sample SampleOf(const performance::State& state, float at_s) {
  return {at_s,
          {state.head.yaw_rad, state.head.pitch_rad, state.head.roll_rad, state.gaze.yaw_rad,
           state.gaze.pitch_rad, std::max(0.0F, state.brow), std::max(0.0F, -state.brow)}};
}

// The name that the curve has in show.toml; empty: it is a channel.
std::string_view NameOf(MotionTarget target) {
  constexpr std::array<std::string_view, 7> kNames{"head_yaw",   "head_pitch", "head_roll", "gaze_yaw",
                                                   "gaze_pitch", "lids",       ""};
  return kNames[static_cast<std::size_t>(target)];
}

// Between two keys a motion eases (performance/motions.cpp): whether that is near enough to all keys between them.
bool IsNear(const Keys& keys, std::size_t from, std::size_t to) {
  const MotionKey &a = keys[from], &b = keys[to];
  for (std::size_t i = from + 1; i < to; ++i) {
    const float t = (keys[i].at_s - a.at_s) / (b.at_s - a.at_s);
    if (std::abs(Mix(a.value, b.value, SmoothStep(t)) - keys[i].value) > kTakeError) return false;
  }
  return true;
}

// Leaves out what lies near enough on the way between others; at most a second is looked ahead.
Keys Thinned(const Keys& keys) {
  constexpr std::size_t kAhead = 60;
  Keys kept{keys.front()};
  for (std::size_t at = 0; at + 1 < keys.size();) {
    std::size_t next = at + 1;
    for (std::size_t far = std::min(at + kAhead, keys.size() - 1); far > next; --far)
      if (IsNear(keys, at, far)) {
        next = far;
        break;
      }
    at = next;
    kept.push_back(keys[at]);
  }
  return kept;
}

// The log is played again up to the stretch and through it. A gap in it is refused: a motion across it would jump. Fewer than
// three frames are no movement.
Result<std::vector<Sample>> Samples(const showlog::LogFile& log, const show::Show& show,
                                    const TakeOptions& options) {
  showlog::Replay replay(log, show);
  replay.GoTo(options.from);
  std::vector<Sample> samples;
  Time first{};
  while (replay.Next() && replay.presented_at() < options.from + options.length) {
    if (replay.presented_at() < options.from) continue;
    if (samples.empty()) first = replay.presented_at();
    if (!samples.empty() && !replay.follows())
      return FailInput(fmt::format("take \"{}\": the log has a gap at {}", options.name,
                                   log.DayTimeText(replay.presented_at())));
    samples.push_back(SampleOf(replay.made().state,
                               options.stretch * static_cast<float>(Seconds(replay.presented_at() - first))));
  }
  if (samples.size() < 3)
    return FailInput(fmt::format("take \"{}\": the log has nothing there", options.name));
  return samples;
}

}  // namespace

// Curves begin and end at 0, as every motion does: both ends are eased in over options.ease_s. What did not move has no curve,
// so that the motion leaves it to whoever plays then.
Result<show::Motion> RecordTake(const showlog::LogFile& log, const show::Show& show,
                                const TakeOptions& options) {
  const auto samples = Samples(log, show, options);
  if (!samples) return tl::unexpected(samples.error());
  show::Motion motion;
  motion.name = options.name;
  const float end_s = samples->back().at_s;
  const auto add = [&](std::size_t value, MotionTarget target, int channel) {
    if (target == MotionTarget::kChannel && channel < 0) return;
    MotionCurve curve{target, static_cast<std::uint16_t>(std::max(0, channel)), {}};
    bool moves = false;
    for (const Sample& sample : *samples) {
      const float edge_s = std::min(sample.at_s, end_s - sample.at_s);
      const float eased = options.ease_s > 0 ? SmoothStep(edge_s / options.ease_s) : 1;
      curve.keys.push_back({sample.at_s, eased * options.gain * sample.values[value]});
      moves = moves || std::abs(curve.keys.back().value) > kMoves;
    }
    curve.keys.front().value = curve.keys.back().value = 0;
    if (!moves) return;
    curve.keys = Thinned(curve.keys);
    motion.curves.push_back(std::move(curve));
  };
  for (std::size_t i = 0; i < 5; ++i) add(i, static_cast<MotionTarget>(i), -1);
  for (const int brow : show.channels.brow_up) add(5, MotionTarget::kChannel, brow);
  add(6, MotionTarget::kChannel, show.channels.brow_frown);
  if (motion.curves.empty()) return FailInput(fmt::format("take \"{}\": nothing moved there", options.name));
  return motion;
}

// As a person would write it into show.toml: angles in degrees, channels by the name of their expression.
// Four digits behind the point are a tenth of a millisecond, and of an angle less than kTakeError.
std::string TextOfTake(const show::Motion& motion, const show::Show& show) {
  std::string text = fmt::format("[[motion]]\nname = \"{}\"\n", motion.name);
  for (const MotionCurve& curve : motion.curves) {
    const bool channel = curve.target == MotionTarget::kChannel;
    const float unit = channel || curve.target == MotionTarget::kLids ? 1 : kDegreesPerRad;
    text += channel ? fmt::format("\"{}\" = [", show.cast.expressions[curve.channel].name)
                    : fmt::format("{} = [", NameOf(curve.target));
    for (std::size_t i = 0; i < curve.keys.size(); ++i)
      text += fmt::format("{}[{:.4f}, {:.4f}]{}", i % 8 == 0 ? "\n  " : " ", curve.keys[i].at_s,
                          curve.keys[i].value * unit, i + 1 < curve.keys.size() ? "," : "\n");
    text += "]\n";
  }
  return text;
}

}  // namespace kaori::authoring
