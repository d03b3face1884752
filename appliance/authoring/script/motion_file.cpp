#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "appliance/authoring/script/show_parts.h"
#include "appliance/authoring/script/wave_file.h"

namespace kaori::authoring {
namespace {

constexpr float kRadPerDegree = std::numbers::pi_v<float> / 180;

// What a curve moves besides the show's channels; angles are written in degrees, all else as a weight of
// 0 to 1.
struct Target {
  std::string_view name;
  show::MotionTarget target;
  bool degrees;  // Else a weight, 0 to 1.
};
constexpr std::array<Target, 6> kTargets{{{"head_yaw", show::MotionTarget::kHeadYaw, true},
                                          {"head_pitch", show::MotionTarget::kHeadPitch, true},
                                          {"head_roll", show::MotionTarget::kHeadRoll, true},
                                          {"gaze_yaw", show::MotionTarget::kGazeYaw, true},
                                          {"gaze_pitch", show::MotionTarget::kGazePitch, true},
                                          {"lids", show::MotionTarget::kLids, false}}};

// Null where it is no target; it may be a channel then.
const Target* TargetNamed(std::string_view name) {
  const auto it = std::ranges::find(kTargets, name, &Target::name);
  return it == kTargets.end() ? nullptr : &*it;
}

// Two numbers.
bool IsPair(const toml::Value& value) {
  const auto is_number = [](const toml::Value& v) { return v.kind == toml::Value::Kind::kNumber; };
  return value.kind == toml::Value::Kind::kList && value.list.size() == 2 &&
         std::ranges::all_of(value.list, is_number);
}

// Reads one curve: pairs [seconds, value]. What is wrong is named with the line of its pair; all pairs are
// read, so that one fault does not hide the next.
class CurveReader {
 public:
  CurveReader(Script& script, std::string item, bool degrees)
      : script_(script), item_(std::move(item)), degrees_(degrees) {}

  // A value that is no pair ends the curve; wrong numbers are told and reading goes on.
  std::vector<show::MotionKey> Read(const toml::Value& pairs) {
    for (const toml::Value& pair : pairs.list) {
      if (!IsPair(pair)) {
        Fault(pair, "a pair [second, value] is expected");
        return {};
      }
      ReadPair(pair, static_cast<float>(pair.list[0].number), static_cast<float>(pair.list[1].number));
    }
    if (keys_.size() < 2) Fault(pairs, "must have two pairs or more");
    // A motion is added to what operators do: one that began or ended elsewhere would make the head jump.
    if (keys_.size() >= 2 && keys_.front().value != 0)
      Fault(pairs.list.front(), "a curve must start and end at 0, so that nothing jumps");
    if (keys_.size() >= 2 && keys_.back().value != 0)
      Fault(pairs.list.back(), "a curve must start and end at 0, so that nothing jumps");
    return std::move(keys_);
  }

 private:
  // Seconds rise from 0 to kLongestMotion_s. NaN fails each comparison, and is a fault.
  void ReadPair(const toml::Value& pair, float at_s, float written) {
    if (!(at_s >= 0 && at_s <= show::kLongestMotion_s))
      Fault(pair, fmt::format("second {} does not lie within 0 to {}", at_s, show::kLongestMotion_s));
    if (!keys_.empty() && !(at_s > keys_.back().at_s))
      Fault(pair, fmt::format("second {} must lie after second {}", at_s, keys_.back().at_s));
    const float value = degrees_ ? written * kRadPerDegree : written;
    if (!(std::abs(value) <= show::kWidestMotion) && degrees_)
      Fault(pair, fmt::format("{} degrees, and {:.0f} to either side are the most", written,
                              std::floor(show::kWidestMotion / kRadPerDegree)));
    else if (!(std::abs(value) <= show::kWidestMotion))
      Fault(pair, fmt::format("{} does not lie within {} to {}; 1 is the whole way", written,
                              -show::kWidestMotion, show::kWidestMotion));
    keys_.push_back({at_s, value});
  }

  void Fault(const toml::Value& at, const std::string& reason) { script_.faults.Add(at.line, item_, reason); }

  Script& script_;
  std::string item_;
  bool degrees_;
  std::vector<show::MotionKey> keys_;
};

// A name is first a target, then an expression of the cast; without a list of those it is taken for one.
show::MotionCurve ReadCurve(Script& script, toml::Section& section, const std::string& user,
                            const std::string& name, const toml::Value& pairs) {
  const Target* target = TargetNamed(name);
  show::MotionCurve curve{target != nullptr ? target->target : show::MotionTarget::kChannel, 0, {}};
  if (target == nullptr && script.known.expressions) {
    // Targets first: that is what most motions move.
    std::vector<std::string_view> names;
    for (const Target& one : kTargets) names.push_back(one.name);
    for (const auto& expression : script.show.cast.expressions) names.emplace_back(expression.name);
    const auto known = std::ranges::find(script.show.cast.expressions, name, &face::Expression::name);
    if (known == script.show.cast.expressions.end())
      section.Fault(
          name, fmt::format("there is no target or channel \"{}\"{}", name, toml::DidYouMean(name, names)));
    else
      curve.channel = static_cast<std::uint16_t>(known - script.show.cast.expressions.begin());
  }
  curve.keys = CurveReader(script, user + "." + name, target != nullptr && target->degrees).Read(pairs);
  return curve;
}

// A WAV file beside show.toml. None, and a fault, where it cannot be read.
show::Sound ReadSound(Script& script, toml::Section& section) {
  const std::string name = section.Text("sound");
  if (name.empty()) {
    section.Fault("sound", "must name a WAV file");
    return {};
  }
  auto sound = ReadWave(script.folder / name);
  if (sound) return std::move(*sound);
  section.Fault("sound", sound.error().message());
  return {};
}

}  // namespace

// Keys of the table that are not name, key or sound are curves, so unknown ones are looked up as such.
show::Motion ReadMotion(Script& script, toml::Section section) {
  show::Motion motion;
  motion.name = section.TextOr("name", "unnamed");
  const std::string user = fmt::format("motion \"{}\"", motion.name);
  for (const show::Motion& other : script.show.motions)
    if (section.Has("name") && other.name == motion.name)
      section.Fault("name", fmt::format("the name \"{}\" is given twice", motion.name));
  if (section.Has("key")) motion.key_usage = KeyNamed(script, section, "key", section.Text("key"), user);
  if (section.Has("sound")) motion.sound = ReadSound(script, section);
  for (const auto& [key, value] : section.table().table) {
    if (key == "name" || key == "key" || key == "sound") continue;
    if (value.kind == toml::Value::Kind::kList)
      motion.curves.push_back(ReadCurve(script, section, user, key, value));
    else
      section.Fault(key, "must be a list of pairs [second, value]");
  }
  // A sound alone is a motion: a line that is played.
  if (motion.curves.empty() && !section.Has("sound")) section.Fault("", "it moves nothing");
  return motion;
}

}  // namespace kaori::authoring
