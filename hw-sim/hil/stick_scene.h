// What checks of sticks share: a box whose service key is on, what it says of a stick, and its list.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/setup.h"

namespace kaori::hil {

inline constexpr int kStickKey = 2;                      // A line of the bridge, as docs/image.md wires it.
inline constexpr std::uint8_t kOne = 0x1E, kTwo = 0x1F;  // Keys, HID page 7.
inline constexpr const char* kSaid = "read /run/kaori-shows/lines";
// The kernel waits before it asks a stick; so does udev.
inline constexpr Duration kLongestReading = std::chrono::seconds(240);
// A show, and a backup: at the lowest priority, beside a face that wants all.
inline constexpr Duration kLongestInstalling = std::chrono::minutes(20);

// A small screen, so that the face leaves the trial something of the processors. With a disk of its own what
// is installed is kept over a start; without one the image's is used, and stays as it ships.
Setup StickSetup(const std::string& disk);

// What the agent answers; empty where there is no such file, or no answer in time: whoever asks again sees
// the next one.
std::string TextInBox(Scene& scene, const std::string& question);

// Looks at what the box says until `right` of it, as long as new words or percents come: what an installation takes as a whole is no
// fault. `look` reads what is said, and may look at more; none: that alone. Errors: invalid_argument, nothing new comes any more, with what
// was said last.
Result<void> UntilSaid(Scene& scene, const std::function<bool(const std::string&)>& right,
                       const std::function<std::string()>& look = {});

// Errors: invalid_argument, the box says something else; with what it says.
Result<void> WantStickSaid(Scene& scene, std::string_view words, Duration longest);

// Plugs a stick of the options' folder in where the rig leaves a port free, as for unauthorised devices: one at a time.
Result<void> Plug(Scene& scene, const std::string& stick);

// The lines of a stick that was pulled are gone: those of the next one have other numbers, or the same words.
Result<void> WantListGone(Scene& scene);

// Does `what` on a box that plays with the service key on, and takes its stick and its power away. `disk`: a name for a copy of the image's
// disk, which keeps what is written; null: nothing is kept. Errors: those of CopyDisk and PlayStrategy::Play, and what `what` gives.
Result<void> InService(Scene& scene, const char* disk, const std::function<Result<void>()>& what);

// Plugs a copy of the empty stick in, which can be written; gives its file.
Result<std::string> PlugEmptyStick(Scene& scene, const std::string& name);

// Presses a key until the box says what it should of it: it may have looked at the keys for the last time
// just before.
Result<void> PressFor(Scene& scene, std::uint8_t key, std::string_view words);

// Presses the key of the list's line with these words until it is worked on or the list has it no more, thrice at most, and waits for what
// the box says of it. Errors: invalid_argument, there is no such line, or the box says something else.
Result<void> ChooseLine(Scene& scene, std::string_view line, std::string_view answer, Duration longest);

// The id of the chosen show. Errors: invalid_argument, none is chosen.
Result<std::string> ChosenId(Scene& scene);

// The stage has begun to play it, and draws.
Result<void> WantPlayed(Scene& scene, const std::string& id);

// Nothing is said of the stick any more, and the kernel has let it go.
Result<void> WantDead(Scene& scene);

// Plugs the stick of a show in, sees the show refused, and takes the key of the theatre that signed it: the image knows no key, so
// that the way of a guest is tried, which has all the steps of the others and one more. The show's line is the first. `show`:
// evening, or guest, whose face came from a modelling tool.
Result<void> BringKey(Scene& scene, const std::string& show);

}  // namespace kaori::hil
