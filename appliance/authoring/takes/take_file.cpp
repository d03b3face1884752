#include "appliance/authoring/takes/take_file.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/authoring/takes/curve_file.h"
#include "appliance/authoring/takes/played.h"
#include "appliance/core/toml/quoted.h"
#include "drivers/base/whole_file.h"

namespace kaori::authoring {
namespace {

constexpr std::string_view kHead =
    "# A take. kaori-atelier take makes and changes this file, and keeps none of its comments: write notes "
    "instead.\n";
constexpr std::size_t kPairsInLine = 6;

// A number of a file, and what it may be. `unit` follows the number: " s".
struct Wanted {
  std::string_view key;
  float least, most;
  const char* unit;
};
constexpr Wanted kFrom{"from_s", 0, show::kLongestMotion_s, " s"},
    kTo{"to_s", 0, show::kLongestMotion_s, " s"};
constexpr Wanted kStretchWanted{"stretch", kFastestTake, kSlowestTake, ""};
constexpr Wanted kGainWanted{"gain", show::kLeastTakeGain, show::kMostTakeGain, ""};
constexpr Wanted kEaseWanted{"ease_s", kShortestEase_s, kLongestEase_s, " s"};
constexpr Wanted kBlend{"blend_s", kShortestBlend_s, kLongestBlend_s, " s"};

float NumberOf(toml::Section& file, const Wanted& wanted, float otherwise) {
  return file.FloatOr(wanted.key, otherwise, wanted.least, wanted.most, wanted.unit);
}

bool SwitchOf(toml::Section& file, std::string_view key) {
  const toml::Value* const value = file.Find(key);
  if (value != nullptr && value->kind != toml::Value::Kind::kSwitch) file.Fault(key, "must be true or false");
  return value != nullptr && value->on;
}

std::vector<TakeCurve> ReadCurves(toml::Section& file, toml::Faults& faults) {
  std::vector<TakeCurve> curves;
  if (!file.Has("curves")) return curves;
  toml::Section part = file.Part("curves");
  for (const auto& [name, value] : part.table().table) {
    if (value.kind != toml::Value::Kind::kList || value.list.empty()) {
      part.Fault(name, "must be a list of pairs [second, value]");
      continue;
    }
    const CurveName* const named = CurveNamed(name);
    TakeCurve curve{.line = value.line};
    if (named != nullptr) curve.target = named->target;
    if (named == nullptr) curve.target = show::MotionTarget::kChannel;
    if (named == nullptr) curve.channel = name;
    curve.keys = ReadCurveKeys(faults, "curves." + name, value, {.name = named, .rests = false});
    curves.push_back(std::move(curve));
  }
  return curves;
}

// What is wrong with numbers that are right by themselves.
void CheckTogether(toml::Section& file, const Take& take) {
  const float recorded_s = RecordedLength(take);
  // Half a tenth of a millisecond: what a person or the tool has rounded.
  if (take.to_s && *take.to_s > recorded_s + 5e-5F)
    file.Fault("to_s", fmt::format("is {} s, and the take was recorded for {} s", *take.to_s, recorded_s));
  const float length_s = PlayedLength(take);
  if (!(length_s >= kShortestTake_s))
    file.Fault(take.to_s ? "to_s" : "from_s",
               fmt::format("leaves nothing of the {} s that were recorded", recorded_s));
  if (length_s > show::kLongestMotion_s)
    file.Fault("stretch",
               fmt::format("makes it {} s long, and {} s is the most", length_s, show::kLongestMotion_s));
  if (take.loop && length_s < kShortestTakeLoop_s)
    file.Fault("loop",
               fmt::format("wants {} s at least, and {:.2f} s are played", kShortestTakeLoop_s, length_s));
  if (!take.sound.empty() && take.loop) file.Fault("loop", "a take with a sound cannot loop");
  if (!take.sound.empty() && take.stretch != 1)
    file.Fault("stretch", "a take with a sound cannot be stretched");
}

// Errors: kInput: all faults, one a line.
Result<Take> ReadFrom(const toml::Value& value, const std::filesystem::path& file, const std::string& name) {
  toml::Faults faults(file.string());
  Take take = ReadTake(toml::Section(value, "", faults), faults, name);
  if (auto ok = faults.Verdict(); !ok) return tl::unexpected(ok.error());
  return take;
}

std::string TextOf(const TakeCurve& curve) {
  const bool channel = curve.target == show::MotionTarget::kChannel;
  std::string text = (channel ? toml::Quoted(curve.channel) : std::string(NameOf(curve))) + " = [";
  for (std::size_t i = 0; i < curve.keys.size(); ++i)
    text += fmt::format("{}[{}, {}]{}", i % kPairsInLine == 0 ? "\n  " : " ", curve.keys[i].at_s,
                        curve.keys[i].value, i + 1 < curve.keys.size() ? "," : "\n");
  return text + "]\n";
}

}  // namespace

bool IsTakeName(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' ||
           c == '-' || c == '_';
  };
  return !name.empty() && name.size() <= 64 && name != kNoTakeName && std::ranges::all_of(name, allowed) &&
         name.front() != ' ' && name.back() != ' ' && name.front() != '-';
}

std::filesystem::path FileOfTake(const std::filesystem::path& folder, std::string_view name) {
  return folder / "takes" / (std::string(name) + ".toml");
}

show::MotionLayer ReadLayer(toml::Section& section) {
  if (!section.Has("layer")) return show::MotionLayer::kAdd;
  const std::string name = section.Text("layer");
  const auto* const found = std::ranges::find(show::kMotionLayerNames, name);
  if (found != show::kMotionLayerNames.end())
    return static_cast<show::MotionLayer>(found - show::kMotionLayerNames.begin());
  if (!name.empty())
    section.Fault("layer",
                  fmt::format("\"{}\" is none of {}", name, fmt::join(show::kMotionLayerNames, ", ")));
  return show::MotionLayer::kAdd;
}

Take ReadTake(toml::Section file, toml::Faults& faults, std::string name) {
  file.AllowOnly({"notes", "key", "sound", "layer", "from_s", "to_s", "stretch", "gain", "ease_s", "loop",
                  "blend_s", "curves"});
  Take take{.name = std::move(name)};
  if (!IsTakeName(take.name))
    file.Fault("", "the name of a take's file is of letters, digits, spaces, - and _, and is not \"none\"");
  for (const auto& [key, into] :
       {std::pair{"notes", &take.notes}, {"key", &take.key}, {"sound", &take.sound}})
    *into = file.TextOr(key, "");
  take.from_s = NumberOf(file, kFrom, take.from_s);
  if (file.Has(kTo.key)) take.to_s = NumberOf(file, kTo, 0);
  take.stretch = NumberOf(file, kStretchWanted, take.stretch);
  take.gain = NumberOf(file, kGainWanted, take.gain);
  take.ease_s = NumberOf(file, kEaseWanted, take.ease_s);
  take.layer = ReadLayer(file);
  take.loop = SwitchOf(file, "loop");
  take.blend_s = NumberOf(file, kBlend, take.blend_s);
  take.curves = ReadCurves(file, faults);
  if (take.curves.empty() && take.sound.empty()) file.Fault("curves", "is missing: it moves nothing");
  if (!faults.any() && !take.curves.empty()) CheckTogether(file, take);
  return take;
}

Result<Take> LoadTake(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path file = FileOfTake(folder, name);
  const auto value = toml::ReadToml(file);
  if (!value) return tl::unexpected(value.error());
  return ReadFrom(*value, file, name);
}

// What is as usual is not written.
std::string TextOf(const Take& take) {
  const Take usual;
  std::string text(kHead);
  for (const auto& [key, value] :
       {std::pair{"notes", &take.notes}, {"key", &take.key}, {"sound", &take.sound}})
    if (!value->empty()) text += fmt::format("{} = {}\n", key, toml::Quoted(*value));
  const auto add = [&text](const Wanted& wanted, float value, float otherwise) {
    if (value != otherwise) text += fmt::format("{} = {}\n", wanted.key, value);
  };
  add(kFrom, take.from_s, usual.from_s);
  if (take.to_s) text += fmt::format("{} = {}\n", kTo.key, *take.to_s);
  add(kStretchWanted, take.stretch, usual.stretch);
  add(kGainWanted, take.gain, usual.gain);
  add(kEaseWanted, take.ease_s, usual.ease_s);
  if (take.layer != usual.layer)
    text += fmt::format("layer = \"{}\"\n", show::kMotionLayerNames[static_cast<std::size_t>(take.layer)]);
  if (take.loop) text += "loop = true\n";
  add(kBlend, take.blend_s, usual.blend_s);
  if (take.curves.empty()) return text;
  text += "\n[curves]\n";
  for (const TakeCurve& curve : take.curves) text += TextOf(curve);
  return text;
}

// What the packer would refuse is not written: the text is read as it would read it.
Result<void> SaveTake(const std::filesystem::path& folder, const Take& take) {
  const std::filesystem::path file = FileOfTake(folder, take.name);
  const std::string text = TextOf(take);
  const auto value = toml::Parse(text, file.string());
  if (!value) return tl::unexpected(value.error());
  if (const auto same = ReadFrom(*value, file, take.name); !same) return tl::unexpected(same.error());
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error)
    return Fail(static_cast<std::errc>(error.value()), "make the folder " + file.parent_path().string());
  return WriteWholeFile(file, {AsBytes(text)});
}

std::string Described(const Take& take) {
  std::vector<std::string_view> names;
  for (const TakeCurve& curve : take.curves) names.push_back(NameOf(curve));
  std::string said = fmt::format("{:.2f} s of {}", RecordedLength(take), fmt::join(names, ", "));
  if (take.from_s != 0 || take.to_s)
    said += fmt::format("; from {:.2f} to {:.2f} s", take.from_s, take.to_s.value_or(RecordedLength(take)));
  if (take.stretch != 1) said += fmt::format("; {:.2f} times as long", take.stretch);
  if (take.gain != 1) said += fmt::format("; {:.2f} times as large", take.gain);
  if (const TakeLoop loop = LoopOf(take); take.loop)
    said += fmt::format("; a loop of {:.2f} s", loop.to_s - loop.from_s);
  if (take.layer != show::MotionLayer::kAdd)
    said += fmt::format("; {} operator input", show::kMotionLayerNames[static_cast<std::size_t>(take.layer)]);
  if (!take.sound.empty()) said += "; with the sound " + take.sound;
  return said;
}

}  // namespace kaori::authoring
