#include <algorithm>
#include <vector>

#include "appliance/authoring/script/show_parts.h"
#include "appliance/authoring/script/wave_file.h"
#include "appliance/authoring/takes/curve_file.h"
#include "appliance/authoring/takes/take_file.h"

namespace kaori::authoring {
namespace {

// A name is first one of kCurveNames, then an expression of the cast; without a list of those it is taken for
// one.
show::MotionCurve ReadMotionCurve(Script& script, toml::Section& section, const std::string& user,
                                  const std::string& name, const toml::Value& pairs) {
  const CurveName* const named = CurveNamed(name);
  show::MotionCurve curve{named != nullptr ? named->target : show::MotionTarget::kChannel, 0, {}};
  if (named == nullptr) {
    const auto channel = ChannelNamed(script, name);
    if (!channel) section.Fault(name, channel.error());
    curve.channel = channel.value_or(0);
  }
  curve.keys = ReadCurveKeys(script.faults, user + "." + name, pairs, {.name = named});
  if (named != nullptr)
    for (show::MotionKey& key : curve.keys) key.value *= named->unit;
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

// Curves' own names first: they are what most motions move.
tl::expected<std::uint16_t, std::string> ChannelNamed(const Script& script, const std::string& name) {
  const auto& expressions = script.show.cast.expressions;
  const auto known = std::ranges::find(expressions, name, &face::Expression::name);
  if (!script.known.expressions || known != expressions.end())
    return script.known.expressions ? static_cast<std::uint16_t>(known - expressions.begin())
                                    : std::uint16_t{0};
  std::vector<std::string_view> names;
  for (const CurveName& one : kCurveNames) names.push_back(one.name);
  for (const face::Expression& expression : expressions) names.emplace_back(expression.name);
  return tl::unexpected(
      fmt::format("there is no target or channel \"{}\"{}", name, toml::DidYouMean(name, names)));
}

// Keys of the table that are not name, key, sound or layer are curves, so unknown ones are looked up as such.
show::Motion ReadMotion(Script& script, toml::Section section) {
  show::Motion motion;
  motion.name = section.TextOr("name", "unnamed");
  const std::string user = fmt::format("motion \"{}\"", motion.name);
  for (const show::Motion& other : script.show.motions)
    if (section.Has("name") && other.name == motion.name)
      section.Fault("name", fmt::format("the name \"{}\" is given twice", motion.name));
  if (section.Has("key")) motion.key_usage = KeyNamed(script, section, "key", section.Text("key"), user);
  if (section.Has("sound")) motion.sound = ReadSound(script, section);
  motion.layer = ReadLayer(section);
  for (const auto& [key, value] : section.table().table) {
    if (key == "name" || key == "key" || key == "sound" || key == "layer") continue;
    if (value.kind == toml::Value::Kind::kList)
      motion.curves.push_back(ReadMotionCurve(script, section, user, key, value));
    else
      section.Fault(key, "must be a list of pairs [second, value]");
  }
  // A sound alone is a motion: a line that is played.
  if (motion.curves.empty() && !section.Has("sound")) section.Fault("", "it moves nothing");
  return motion;
}

}  // namespace kaori::authoring
