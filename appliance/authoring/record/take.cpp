#include "appliance/authoring/record/take.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "appliance/authoring/takes/curve_names.h"
#include "appliance/authoring/takes/edit.h"
#include "appliance/core/performance/ease.h"
#include "appliance/core/showlog/replay.h"

namespace kaori::authoring {
namespace {

using performance::SmoothStep;
using show::Level;
using show::MotionTarget;

// Less than this, in degrees, is the noise of a stick that nobody holds; of weights a thousandth.
constexpr float kMoves = 0.05F, kMovesWeight = 1e-3F;
constexpr std::size_t kBrowCurves = 3, kMouthShapes = 4;

// What one frame says, in radians, metres and weights.
struct Sample {
  float at_s = 0;
  std::array<float, 7> values{};  // In the order of kCurveNames.
  // A brow has curves for each way, since a channel only goes from 0 to 1: left up, right up, frown.
  std::array<float, kBrowCurves> brows{};
  std::array<float, kMouthShapes> mouth{};
};

// Both lids: a wink of one eye has no curve of its own.
float LidsOf(const performance::State& state) {
  const auto shut = [&state](std::size_t eye, Level level) {
    return std::max(SmoothStep(state.lids_held[eye]), state.levels[static_cast<std::size_t>(level)].value);
  };
  return std::min(shut(0, Level::kLidLeft), shut(1, Level::kLidRight));
}

// The shares of the mouth's four shapes, as MoveMouth adds them.
std::array<float, kMouthShapes> MouthOf(const performance::State& state) {
  const float open = state.mouth_open, wide = state.mouth_wide;
  const float drive = SmoothStep(state.mouth_drive), said = state.mouth_said;
  return {drive * (1 - open) * (1 - wide), drive * (1 - open) * wide, said * open * (1 - wide),
          said * open * wide};
}

// The state has what operators moved, without life and motions on top of it: those play again by themselves.
Sample SampleOf(const performance::State& state, float at_s) {
  const float up = std::max(0.0F, state.brow), frown = std::max(0.0F, -state.brow);
  return {at_s,
          {state.head.yaw_rad, state.head.pitch_rad, state.head.roll_rad, state.head.shift_m.z,
           state.gaze.yaw_rad, state.gaze.pitch_rad, LidsOf(state)},
          {up, up, frown},
          MouthOf(state)};
}

// Which levels say what a curve of kCurveNames says.
constexpr std::array<std::array<Level, 2>, 7> kLevelsOfCurves{{{Level::kHeadYaw, Level::kHeadYaw},
                                                               {Level::kHeadPitch, Level::kHeadPitch},
                                                               {Level::kHeadRoll, Level::kHeadRoll},
                                                               {Level::kHeadLean, Level::kHeadLean},
                                                               {Level::kGazeYaw, Level::kGazeYaw},
                                                               {Level::kGazePitch, Level::kGazePitch},
                                                               {Level::kLidLeft, Level::kLidRight}}};

bool Has(std::uint32_t levels, Level level) {
  return (levels >> static_cast<unsigned>(level) & 1U) != 0;
}

// Whether the motion has just begun in this state: -1 where it has not, else the seconds that it has played.
float BegunSince(const performance::State& state, std::int32_t motion) {
  for (const performance::Playing& voice : state.voices)
    if (voice.motion == motion && voice.ends == 0) return voice.at_s;
  return -1;
}

tl::unexpected<Error> Refuse(const RecordOptions& options, std::string_view why) {
  return FailInput(fmt::format("take \"{}\": {}", options.name, why));
}

// The index of the motion with which the take begins; -1: with none.
Result<std::int32_t> MotionBeside(const show::Show& show, const RecordOptions& options) {
  if (options.with.empty()) return -1;
  const auto found = std::ranges::find(show.motions, options.with, &show::Motion::name);
  if (found == show.motions.end())
    return Refuse(options, fmt::format("the show has no motion or take \"{}\"", options.with));
  return static_cast<std::int32_t>(found - show.motions.begin());
}

// The log is played again up to the stretch and through it. A gap in it is refused: a take across it would
// jump. Fewer than three frames are no movement.
Result<std::vector<Sample>> Samples(const showlog::LogFile& log, const show::Show& show,
                                    const RecordOptions& options) {
  const auto beside = MotionBeside(show, options);
  if (!beside) return tl::unexpected(beside.error());
  showlog::Replay replay(log, show);
  replay.GoTo(options.from);
  std::vector<Sample> samples;
  Time first{};
  float played_before_s = -1;  // Of the motion beside it, at the frame before.
  while (replay.Next() && replay.presented_at() < options.to) {
    const performance::State& state = replay.made().state;
    const float played_s = *beside >= 0 ? BegunSince(state, *beside) : -1;
    const bool begins = *beside < 0 || (played_s >= 0 && (played_before_s < 0 || played_s < played_before_s));
    played_before_s = played_s;
    if (replay.presented_at() < options.from || (samples.empty() && !begins)) continue;
    if (samples.empty())
      first = replay.presented_at() - FromSeconds(static_cast<double>(std::max(0.0F, played_s)));
    if (!samples.empty() && !replay.follows())
      return Refuse(options, "the log has a gap at " + log.DayTimeText(replay.presented_at()));
    samples.push_back(SampleOf(state, static_cast<float>(Seconds(replay.presented_at() - first))));
  }
  if (samples.empty() && *beside >= 0)
    return Refuse(options, fmt::format("\"{}\" did not begin there", options.with));
  if (samples.size() < 3) return Refuse(options, "the log has nothing there");
  return samples;
}

// Adds curves of what moves.
class CurveWriter {
 public:
  CurveWriter(const std::vector<Sample>& samples, Take& take) : samples_(samples), take_(take) {}

  // `value_of(sample)`, divided by `unit`, is what the curve says.
  template <class ValueOf>
  void Add(MotionTarget target, const std::string& channel, float unit, ValueOf value_of) {
    TakeCurve curve{target, channel, {}};
    for (const Sample& sample : samples_) curve.keys.push_back({sample.at_s, value_of(sample) / unit});
    curve.keys = Rounded(Thinned(curve.keys, unit == 1 ? kTakeError * kRadPerDegree : kTakeError));
    take_.curves.push_back(std::move(curve));
  }

  template <class ValueOf>
  bool Moves(float unit, ValueOf value_of) const {
    return std::ranges::any_of(samples_, [&](const Sample& sample) {
      return std::abs(value_of(sample) / unit) > (unit == 1 ? kMovesWeight : kMoves);
    });
  }

 private:
  const std::vector<Sample>& samples_;
  Take& take_;
};

// All channels of the brows where one of them moves, so that a later pass over this one takes all of them.
void AddGroup(CurveWriter& writer, const show::Show& show, std::span<const int> channels,
              const auto& values_of) {
  bool moves = false;
  for (std::size_t i = 0; i < channels.size(); ++i)
    moves = moves || writer.Moves(1, [&](const Sample& sample) { return values_of(sample)[i]; });
  for (std::size_t i = 0; moves && i < channels.size(); ++i)
    if (channels[i] >= 0)
      writer.Add(MotionTarget::kChannel, show.cast.expressions[static_cast<std::size_t>(channels[i])].name, 1,
                 [&](const Sample& sample) { return values_of(sample)[i]; });
}

}  // namespace

std::optional<std::uint32_t> LevelsOfRole(const show::Show& show, const std::string& role) {
  const auto found = std::ranges::find(show.roles.roles, role, &show::Role::name);
  if (found == show.roles.roles.end()) return std::nullopt;
  std::uint32_t levels = 0;
  for (const show::RoleMap& map : found->maps) levels |= 1U << static_cast<unsigned>(map.level);
  return levels;
}

Result<Take> RecordTake(const showlog::LogFile& log, const show::Show& show, const RecordOptions& options) {
  const auto samples = Samples(log, show, options);
  if (!samples) return tl::unexpected(samples.error());
  Take take{.name = options.name};
  CurveWriter writer(*samples, take);
  for (std::size_t i = 0; i < kCurveNames.size(); ++i) {
    const auto value_of = [i](const Sample& sample) { return sample.values[i]; };
    const bool wanted =
        Has(options.levels, kLevelsOfCurves[i][0]) || Has(options.levels, kLevelsOfCurves[i][1]);
    if (wanted && writer.Moves(kCurveNames[i].unit, value_of))
      writer.Add(kCurveNames[i].target, "", kCurveNames[i].unit, value_of);
  }
  const std::array<int, kBrowCurves> brows{show.channels.brow_up[0], show.channels.brow_up[1],
                                           show.channels.brow_frown};
  if (Has(options.levels, Level::kBrow))
    AddGroup(writer, show, brows, [](const Sample& sample) { return sample.brows; });
  if (options.mouth)
    AddGroup(writer, show, show.channels.mouth, [](const Sample& sample) { return sample.mouth; });
  if (take.curves.empty()) return Refuse(options, "nothing moved there");
  return take;
}

}  // namespace kaori::authoring
