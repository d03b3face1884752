// Mistakes of a show's files, each with what is said of it; here those of roles.toml and cues.toml.
#pragma once

#include <ostream>

namespace kaori::tests {

struct Mistake {
  const char* name;
  const char* file;
  const char* what;  // Is replaced where it first stands; empty: `with` is put at the end of the file.
  const char* with;
  const char* says;  // A regular expression.
  friend void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }
};

inline const Mistake kInTheCues[] = {
    {"RoleOfNoLevel", "roles.toml", "level = \"head_lean\"", "level = \"head_leen\"",
     "roles.toml:[0-9]+: role \"head\".map\\[4\\].level: \"head_leen\" is none of face, expression"},
    {"RoleOnADeviceThatIsNone", "roles.toml", "device = \"right stick\"", "device = \"middle stick\"",
     "roles.toml:[0-9]+: role \"gaze\".device: \"middle stick\" is none of left stick, right stick, dial "
     "box"},
    {"CueThatReleasesNoLevel", "cues.toml", "motion = \"bow\"", "release = [\"haed_yaw\"]",
     "cues.toml:[0-9]+: cue 6.release: there is no level \"haed_yaw\"; did you mean \"head_yaw\"[?]"},
    {"CueThatUnlocks", "cues.toml", "motion = \"bow\"", "lock = false",
     "cues.toml:[0-9]+: cue 6.lock: must be true, or not stand here: the service key alone unlocks a show"},
    {"CueOfNoFace", "cues.toml", "{ name = \"poster\", in_s = 0 }", "{ name = \"pester\", in_s = 0 }",
     "cues.toml:[0-9]+: cue 1.scene.name: there is no scene \"pester\"; did you mean \"poster\"[?]"},
    {"CueOfNoExpression", "cues.toml", "name = \"surprised\", in_s = 0.6", "name = \"suprised\", in_s = 0.6",
     "cues.toml:[0-9]+: cue 2.1.expression.name: there is no expression \"suprised\"; did you mean"},
    {"CueOfNoMotion", "cues.toml", "motion = \"bow\"", "motion = \"bough\"",
     "cues.toml:[0-9]+: cue 6.motion: there is no motion \"bough\""},
    {"CueOfNoTake", "cues.toml", "motion = \"bow\"", "take = \"bough\"",
     "cues.toml:[0-9]+: cue 6.take: there is no take \"bough\""},
    {"CueOfATakeInNoLayer", "cues.toml", "motion = \"bow\"", "motion = { name = \"bow\", layer = \"below\" }",
     "cues.toml:[0-9]+: cue 6.motion.layer: \"below\" is none of add, under, over"},
    {"CueOfATakeThatIsTooLarge", "cues.toml", "motion = \"bow\"", "motion = { name = \"bow\", gain = 80 }",
     "cues.toml:[0-9]+: cue 6.motion.gain: is 80, not within 0.1 to 2"},
    {"CueOfATakeFromBehindItsEnd", "cues.toml", "motion = \"bow\"",
     "motion = { name = \"bow\", from_s = 300 }",
     "cues.toml:[0-9]+: cue 6.motion.from_s: is 300 s, and \"bow\" has ended by [0-9.]+ s"},
    {"CueOfNoTakeInATable", "cues.toml", "motion = \"bow\"", "take = { name = \"bough\" }",
     "cues.toml:[0-9]+: cue 6.take.name: there is no take \"bough\""},
    {"CueThatEndsTakesInALayer", "cues.toml", "motion = \"bow\"", "take = { name = \"none\", gain = 1 }",
     "cues.toml:[0-9]+: cue 6.take.gain: is said of a motion, and \"none\" is none"},
    {"CueThatWaitsForALookAtNoSeat", "cues.toml", "voice_quiet_s = 1.2", "gaze_on = \"seat 21\"",
     "cues.toml:[0-9]+: cue 3.wait_for.gaze_on: there is no gaze target \"seat 21\"; did you mean \"seat "
     "12\"[?]"},
    {"CueThatWaitsForALookAtNobody", "cues.toml", "voice_quiet_s = 1.2", "gaze_on = \"nobody\"",
     "cues.toml:[0-9]+: cue 3.wait_for.gaze_on: names nobody: a look rests on one of .gaze."},
    {"CueThatWaitsForALookForEver", "cues.toml", "voice_quiet_s = 1.2, at_most_s = 20",
     "gaze_on = \"seat 12\"",
     "cues.toml:[0-9]+: cue 3.wait_for.at_most_s: is missing: nobody may come, and the evening must go on"},
    {"CueThatWaitsForAVoiceAsForALook", "cues.toml", "voice_quiet_s = 1.2,",
     "voice_quiet_s = 1.2, gaze_s = 1,",
     "cues.toml:[0-9]+: cue 3.wait_for.gaze_s: is how long a look rests; it stands beside gaze_on"},
    {"CueOfANumberThatFalls", "cues.toml", "number = \"3.1\"", "number = \"2.9\"",
     "cues.toml:[0-9]+: cue 2.9.number: 2.9 stands after 3; numbers must rise"},
    {"CueOfANumberThatIsTaken", "cues.toml", "number = \"2\"", "number = \"1\"",
     "cues.toml:[0-9]+: cue 1.number: 1 stands after 1; numbers must rise"},
    {"CueOfNoNumber", "cues.toml", "number = \"14\"", "number = \"fourteen\"",
     "cues.toml:[0-9]+: cue fourteen.number: \"fourteen\" is no number of a cue: digits and single dots"},
    {"CueOfANumberWithoutQuotes", "cues.toml", "number = \"14\"", "number = 14",
     "cues.toml:[0-9]+: cue\\[[0-9]+\\].number: must be a text in quotes"},
    {"CueThatWaitsForEver", "cues.toml", "voice_quiet_s = 1.2, at_most_s = 20", "voice_quiet_s = 1.2",
     "cues.toml:[0-9]+: cue 3.wait_for.at_most_s: is missing: nobody may come, and the evening must go on"},
    {"CueThatWaitsForTwo", "cues.toml", "voice_quiet_s = 1.2, ", "voice_quiet_s = 1.2, mouth_shut_s = 1, ",
     "cues.toml:[0-9]+: cue 3.wait_for: wants one of mouth_shut_s, voice_quiet_s, presence_s, gaze_on"},
    {"CueOfAFadeInMilliseconds", "cues.toml", "in_s = 2.5", "in_s = 2500",
     "cues.toml:[0-9]+: cue 11.style.in_s: is 2500 s, not within 0 to 1800"},
    {"CueOfLightInPercent", "cues.toml", "to = 0.55", "to = 55",
     "cues.toml:[0-9]+: cue 1.light.to: is 55, not within 0 to 1"},
    {"CueOfAWordThatIsNone", "cues.toml", "continue = \"follow\"", "continue = \"folow\"",
     "cues.toml:[0-9]+: cue 2.1.continue: \"folow\" is none of no, continue, follow"},
    {"CueOfAKeyThatIsNone", "cues.toml", "pre_wait_s = 0.5", "pre_wait = 0.5",
     "cues.toml:[0-9]+: cue 3.1.pre_wait: is not known here; did you mean \"pre_wait_s\"[?]"},
    {"LastCueThatContinues", "cues.toml", "", "continue = \"follow\"\n",
     "cues.toml:[0-9]+: cue 40: it is the last one: no cue continues or follows it"},
    {"PanicOfNoScene", "cues.toml", "{ name = \"studio\", in_s = 1.0 }", "{ name = \"sudio\" }",
     "cues.toml:[0-9]+: list.panic.name: there is no scene \"sudio\"; did you mean \"studio\"[?]"},
    {"GuardInSeconds", "cues.toml", "go_guard_ms = 300", "go_guard_s = 0.3",
     "cues.toml:[0-9]+: list.go_guard_s: is not known here"},
    {"KeyOfNoCallOfTheList", "show.toml", "enter = \"cue go\"", "enter = \"cue goo\"",
     "show.toml:[0-9]+: keys.enter: the cue list knows no \"goo\"; it knows go, back, stop"},
};

}  // namespace kaori::tests
