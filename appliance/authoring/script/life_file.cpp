#include <algorithm>
#include <array>

#include "appliance/authoring/script/show_parts.h"

namespace kaori::authoring {
namespace {

// In the order of show::LifePart.
constexpr std::array<const char*, show::kLifePartCount> kLifeParts{"blink", "glance", "head", "breath",
                                                                   "accents"};
// Words for the gaze that every show has: nobody is no place and cannot be given one, the camera can be
// moved.
constexpr const char* kNobodyName = "nobody";
constexpr const char* kCameraName = "camera";
// Where the picture's own viewer is: whoever sees the picture is looked at.
constexpr glm::vec3 kCamera_m{0, 0, 0.95F};

float LifeAmount(toml::Section& section, std::string_view key, float otherwise) {
  return Between(section, key, otherwise, show::kMostLife, "");
}

// A place that is there already is moved: so a show has its own house, or its own camera.
void ReadTarget(Script& script, toml::Section& gaze, const std::string& name) {
  auto& targets = script.show.gaze_targets;
  const glm::vec3 at_m(gaze.Point(name));
  if (name == kNobodyName) return gaze.Fault(name, "means that she looks at nobody, and is no place");
  if (!show::IsTarget(at_m))
    gaze.Fault(
        name,
        fmt::format("is no place before her: [left, up, to the audience] in metres, {} to {} m away, and not "
                    "more than 60 degrees aside",
                    show::kNearestTarget_m, show::kFarthestTarget_m));
  const auto there = std::ranges::find(targets, name, &show::GazeTarget::name);
  if (there != targets.end())
    there->at_m = at_m;
  else
    targets.push_back({name, at_m});
}

}  // namespace

// House and camera are there before the file is read, so that the house is the first one, as HouseOf counts
// on.
void ReadGazeTargets(Script& script, toml::Section gaze) {
  script.show.gaze_targets = {{show::kHouseName, show::kHouse_m}, {kCameraName, kCamera_m}};
  for (const auto& entry : gaze.table().table) ReadTarget(script, gaze, entry.first);
  if (script.show.gaze_targets.size() > show::kMostGazeTargets)
    gaze.Fault("", fmt::format("has {} targets, and {} is the most", script.show.gaze_targets.size(),
                               show::kMostGazeTargets));
}

std::int32_t GazeNamed(Script& script, toml::Section& section, std::string_view key,
                       const std::string& name) {
  if (name == kNobodyName) return show::kNoTarget;
  return IndexOf(section, key, "gaze target", script.show.gaze_targets, name);
}

show::LifeAmounts LifeAt(toml::Section& section, std::string_view key, float otherwise) {
  show::LifeAmounts amounts;
  amounts.fill(otherwise);
  const toml::Value* value = section.Find(key);
  if (value == nullptr) return amounts;
  if (value->kind == toml::Value::Kind::kNumber) {
    amounts.fill(LifeAmount(section, key, 1));
    return amounts;
  }
  toml::Section part = section.Part(key);
  part.AllowOnly({kLifeParts[0], kLifeParts[1], kLifeParts[2], kLifeParts[3], kLifeParts[4]});
  for (std::size_t n = 0; n < amounts.size(); ++n)
    if (part.Has(kLifeParts[n])) amounts[n] = LifeAmount(part, kLifeParts[n], 1);
  return amounts;
}

}  // namespace kaori::authoring
