#include <algorithm>
#include <array>

#include "appliance/authoring/script/show_parts.h"
#include "appliance/authoring/takes/take.h"
#include "appliance/authoring/takes/take_file.h"

namespace kaori::authoring {
namespace {

// What cues may wait for, each under a key of its own: of seconds, or of whom the look rests on.
struct PersonKey {
  std::string_view key;
  show::CuePerson person;
};
constexpr std::array<PersonKey, 4> kPersons{{{"mouth_shut_s", show::CuePerson::kMouthShut},
                                             {"voice_quiet_s", show::CuePerson::kVoiceQuiet},
                                             {"presence_s", show::CuePerson::kPresence},
                                             {"gaze_on", show::CuePerson::kGazeOn}}};

// A look that rests for less may only pass by: people fixate for 0.2 s at least.
constexpr float kLookRests_s = 0.3F;

// What a cue says of a motion besides its name. `motion` is null where it ends those that play.
show::MotionUse ReadUse(toml::Section& part, const show::Motion* motion) {
  show::MotionUse use;
  for (const char* key : {"layer", "gain", "from_s"})
    if (motion == nullptr && part.Has(key)) part.Fault(key, "is said of a motion, and \"none\" is none");
  if (motion == nullptr) return use;
  if (part.Has("layer")) use.layer = ReadLayer(part);
  use.gain = static_cast<float>(part.NumberOr("gain", 1));
  if (!(use.gain >= show::kLeastTakeGain && use.gain <= show::kMostTakeGain))
    part.Fault("gain", fmt::format("is {}, not within {} to {}", use.gain, show::kLeastTakeGain,
                                   show::kMostTakeGain));
  use.from_s = Between(part, "from_s", 0, show::kLongestMotion_s, " s");
  // A take with faults of its own is known by its name alone, and has no length.
  const float end_s = motion->Loops() ? motion->loop_to_s : show::EndOf(*motion);
  if (end_s > 0 && use.from_s >= end_s)
    part.Fault("from_s",
               fmt::format("is {} s, and \"{}\" has ended by {:.2f} s", use.from_s, motion->name, end_s));
  return use;
}

}  // namespace

void ReadCueMotion(Script& script, toml::Section& section, show::Cue& cue) {
  const char* const key = section.Has("take") ? "take" : "motion";
  if (section.Has("take") && section.Has("motion"))
    section.Fault("take", "stands beside a motion; a cue plays one of them");
  const toml::Value* value = section.Find(key);
  if (value == nullptr) return;
  const auto named = [&](toml::Section& at, std::string_view name_key, const std::string& name) {
    if (name == kNoTakeName)
      cue.motion = show::kEndsMotion;
    else if (!name.empty())
      cue.motion = IndexOf(at, name_key, key, script.show.motions, name);
  };
  if (value->kind != toml::Value::Kind::kTable) return named(section, key, section.Text(key));
  toml::Section part = section.Part(key);
  part.AllowOnly({"name", "layer", "gain", "from_s"});
  named(part, "name", part.Text("name"));
  const auto& motions = script.show.motions;
  const bool known = cue.motion >= 0 && !motions.empty();
  if (known || cue.motion == show::kEndsMotion)
    cue.use = ReadUse(part, known ? &motions[static_cast<std::size_t>(cue.motion)] : nullptr);
}

void CheckFollow(Script& script, toml::Section& section, const show::Cue& cue) {
  const auto& motions = script.show.motions;
  if (cue.next != show::CueNext::kFollow || cue.motion < 0 || motions.empty()) return;
  const show::Motion& motion = motions[static_cast<std::size_t>(cue.motion)];
  if (motion.Loops())
    section.Fault("continue", fmt::format("\"{}\" loops and has no end: nothing can follow it", motion.name));
}

show::CueWait ReadCueWait(Script& script, toml::Section& section) {
  if (!section.Has("wait_for")) return {};
  toml::Section part = section.Part("wait_for");
  part.AllowOnly({"mouth_shut_s", "voice_quiet_s", "presence_s", "gaze_on", "gaze_s", "at_most_s"});
  const auto given = [&part](const PersonKey& person) { return part.Has(person.key); };
  if (std::ranges::count_if(kPersons, given) != 1) {
    part.Fault("", "wants one of mouth_shut_s, voice_quiet_s, presence_s, gaze_on");
    return {};
  }
  const PersonKey& person = *std::ranges::find_if(kPersons, given);
  const bool look = person.person == show::CuePerson::kGazeOn;
  show::CueWait wait{.person = person.person};
  if (look) wait.target = GazeNamed(script, part, "gaze_on", part.Text("gaze_on"));
  if (look && wait.target == show::kNoTarget)
    part.Fault("gaze_on", "names nobody: a look rests on one of [gaze]");
  if (!look && part.Has("gaze_s")) part.Fault("gaze_s", "is how long a look rests; it stands beside gaze_on");
  if (!part.Has("at_most_s"))
    part.Fault("at_most_s", "is missing: nobody may come, and the evening must go on");
  wait.for_s =
      Between(part, look ? "gaze_s" : person.key, look ? kLookRests_s : 0, show::kLongestWait_s, " s");
  wait.at_most_s = Between(part, "at_most_s", wait.for_s, show::kLongestWait_s, " s");
  if (wait.at_most_s < wait.for_s || !(wait.at_most_s > 0))
    part.Fault("at_most_s", fmt::format("is {} s, shorter than what is waited for", wait.at_most_s));
  return wait;
}

}  // namespace kaori::authoring
