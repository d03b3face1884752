#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "appliance/authoring/script/show_parts.h"
#include "appliance/authoring/script/wave_file.h"
#include "appliance/authoring/takes/curve_names.h"
#include "appliance/authoring/takes/played.h"
#include "appliance/authoring/takes/take_file.h"
#include "drivers/base/folder.h"

namespace kaori::authoring {
namespace {

// A sound that is cut begins and ends so softly that no click is heard.
constexpr float kSoundEdge_s = 0.005F;

// The files of takes, by their names; none where there is no such folder.
std::vector<std::filesystem::path> FilesOfTakes(Script& script) {
  const std::filesystem::path folder = script.folder / "takes";
  if (!IsThere(folder)) return {};
  auto files = ListFolder(folder);
  if (!files) {
    script.faults_of_takes.push_back(
        fmt::format("{}: {}", folder.string(), std::make_error_code(files.error().cause).message()));
    return {};
  }
  std::erase_if(*files, [](const std::filesystem::path& file) { return file.extension() != ".toml"; });
  return std::move(*files);
}

// The part of a sound that goes with what is played of its take.
void Trim(show::Sound& sound, const Take& take) {
  if (take.from_s == 0 && !take.to_s) return;
  const auto channels = static_cast<std::size_t>(sound.channels);
  const auto at = [&](float second) {
    const auto frame =
        static_cast<std::size_t>(std::lround(second * static_cast<float>(show::kSoundRate_hz)));
    return static_cast<std::ptrdiff_t>(std::min(frame * channels, sound.samples.size()));
  };
  if (take.to_s) sound.samples.erase(sound.samples.begin() + at(*take.to_s), sound.samples.end());
  sound.samples.erase(sound.samples.begin(), sound.samples.begin() + at(take.from_s));
  const std::size_t frames = sound.samples.size() / channels;
  const auto edge =
      std::min(frames / 2, static_cast<std::size_t>(kSoundEdge_s * static_cast<float>(show::kSoundRate_hz)));
  for (std::size_t i = 0; i < edge * channels; ++i) {
    const float share = static_cast<float>(i / channels) / static_cast<float>(edge);
    const auto soften = [share](std::int16_t& sample) {
      sample = static_cast<std::int16_t>(std::lround(share * static_cast<float>(sample)));
    };
    soften(sound.samples[i]);
    soften(sound.samples[sound.samples.size() - 1 - i]);
  }
}

// What the file names elsewhere is looked up: the key, the sound, the expressions.
show::Motion MotionOf(Script& script, toml::Section& file, toml::Faults& faults, const Take& take) {
  show::Motion motion{.name = take.name, .curves = {}, .recorded = true};
  if (std::ranges::find(script.show.motions, take.name, &show::Motion::name) != script.show.motions.end())
    file.Fault("", fmt::format("show.toml has a motion \"{}\" already", take.name));
  if (!take.key.empty())
    motion.key_usage = KeyNamed(script, file, "key", take.key, fmt::format("take \"{}\"", take.name));
  if (!take.sound.empty()) {
    auto sound = ReadWave(script.folder / take.sound);
    if (!sound) file.Fault("sound", sound.error().message());
    if (sound) motion.sound = std::move(*sound);
    Trim(motion.sound, take);
  }
  const TakeLoop loop = LoopOf(take);
  motion.loop_from_s = loop.from_s;
  motion.loop_to_s = loop.to_s;
  motion.layer = take.layer;
  for (const TakeCurve& curve : take.curves) {
    const bool channel = curve.target == show::MotionTarget::kChannel;
    const auto index = channel ? ChannelNamed(script, curve.channel) : std::uint16_t{0};
    if (!index) faults.Add(curve.line, "curves." + curve.channel, index.error());
    if (auto keys = PlayedKeys(take, curve); index && keys.size() >= 2)
      motion.curves.push_back({curve.target, *index, std::move(keys)});
  }
  if (motion.curves.empty() && take.sound.empty())
    file.Fault("from_s", "nothing moves in the part that is played");
  return motion;
}

// Nothing is made of a take with faults, but its name is known.
show::Motion ReadTakeOf(Script& script, const std::filesystem::path& path) {
  const std::string name = path.stem().string();
  const auto value = toml::ReadToml(path);
  if (!value) {
    script.faults_of_takes.push_back(value.error().message());
    return {.name = name, .curves = {}};
  }
  toml::Faults faults(path.string());
  toml::Section file(*value, "", faults);
  const Take take = ReadTake(file, faults, name);
  show::Motion motion =
      faults.any() ? show::Motion{.name = name, .curves = {}} : MotionOf(script, file, faults, take);
  std::ranges::copy(faults.lines(), std::back_inserter(script.faults_of_takes));
  return motion;
}

}  // namespace

void ReadTakes(Script& script) {
  for (const std::filesystem::path& file : FilesOfTakes(script))
    script.show.motions.push_back(ReadTakeOf(script, file));
}

}  // namespace kaori::authoring
