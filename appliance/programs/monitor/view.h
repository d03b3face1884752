// What the operators' monitor says, in words and shares: of the show, of whoever plays it, and of the box.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/board/sections.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"
#include "appliance/programs/status/lines.h"
#include "drivers/base/clock.h"
#include "render/image/fill.h"

namespace kaori::monitor {

// All that the monitor depends on, at one moment. Borrows show and state.
struct Moment {
  const show::Show& show;
  const performance::State& state;
  board::Stamped<board::ShowNow> show_now{};
  board::Stamped<board::Lips> lips{};
  board::Stamped<board::Voice> voice{};
  board::Stamped<board::StageStatus> stage_status{};
  board::Stamped<board::Lines> lines{};
  std::vector<status::Line> status{};  // As the status picture says them.
  std::string time_of_day{};           // Empty: nobody knows it.
  Time now{};
};

// A cue of the list, for people; empty where there is none.
struct CueWords {
  std::string number{}, name{}, notes{};
};

// Something with a colour of its own: a mark of the head line, a role, what is on.
struct Tag {
  std::string words;
  image::Colour colour{};
  friend bool operator==(const Tag&, const Tag&) = default;
};

// What is on: a face, an expression, a motion.
struct Playing {
  std::string what;   // "face"
  std::string words;  // "narrator"
  image::Colour colour{};
  float share = 1;  // Of a fade or a motion that runs; 1: it has run.
};

// A level as a bar; shares are of its way from the lower to the upper end.
struct Level {
  std::string name;   // "head yaw"
  std::string owner;  // "head", a role; empty: nobody has it.
  image::Colour colour{};
  float share = 0;
  float rest = 0;
};

struct View {
  std::string time_of_day;  // "19:43:10"; empty: nobody knows it.
  std::string act;          // "ACT Two"; "CUE LIST" where it has no acts; empty before the first cue.
  std::string act_time;     // "1:02:33" since it began; empty: nobody knows.
  std::vector<Tag> marks;   // Lock, blackout, pause and the like; none where all is usual.
  Tag go{};                 // What GO does now.
  CueWords standby, active;
  std::string comes;  // What the list does by itself: "3.1 comes in 4.0 s".
  std::vector<Playing> playing;
  std::vector<Tag> roles;  // With the devices from which they are played.
  std::vector<Level> levels;
  Tag lips{};           // How the camera sees the mouth, in words.
  float open = 0;       // The mouth as the camera sees it, 0 shut .. 1 open; 0 where it sees none.
  float voice = 0;      // How loud the voice is, 0 .. 1.
  bool speaks = false;  // Loud enough for the mouth.
  Tag fault{};          // What is wrong or missing, in one line.
  std::string rate;     // "59.9 pictures a second"
};

// What a level, its bar and its role's name are drawn in; `role` counts where one has it.
image::Colour ColourOf(board::LevelOwner owner, std::uint32_t role);

// Pure; equal moments give equal views.
View Describe(const Moment& moment);

// "0:00:07" up to "99:59:59"; negative lengths are none.
std::string ClockText(Duration length);

}  // namespace kaori::monitor
