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
  // As the status picture says them.
  std::vector<status::Line> status{};
  // Empty: nobody knows it.
  std::string time_of_day{};
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
  // "face"
  std::string what;
  // "narrator"
  std::string words;
  image::Colour colour{};
  // Of a fade or a motion that runs; 1: it has run.
  float share = 1;
};

// A level as a bar; shares are of its way from the lower to the upper end.
struct Level {
  // "head yaw"
  std::string name;
  // "head", a role; empty: nobody has it.
  std::string owner;
  image::Colour colour{};
  float share = 0;
  float rest = 0;
};

struct View {
  // "19:43:10"; empty: nobody knows it.
  std::string time_of_day;
  // "ACT Two"; "CUE LIST" where it has no acts; empty before the first cue.
  std::string act;
  // "1:02:33" since it began; empty: nobody knows.
  std::string act_time;
  // Lock, blackout, pause and the like; none where all is usual.
  std::vector<Tag> marks;
  // What GO does now.
  Tag go{};
  CueWords standby, active;
  // What the list does by itself: "3.1 comes in 4.0 s".
  std::string comes;
  std::vector<Playing> playing;
  // With the devices from which they are played.
  std::vector<Tag> roles;
  std::vector<Level> levels;
  // How the camera sees the mouth, in words.
  Tag lips{};
  // The mouth as the camera sees it, 0 shut .. 1 open; 0 where it sees none.
  float open = 0;
  // How loud the voice is, 0 .. 1.
  float voice = 0;
  // Loud enough for the mouth.
  bool speaks = false;
  // What is wrong or missing, in one line.
  Tag fault{};
  // "59.9 pictures a second"
  std::string rate;
};

// What a level, its bar and its role's name are drawn in; `role` counts where one has it.
image::Colour ColourOf(board::LevelOwner owner, std::uint32_t role);

// Pure; equal moments give equal views.
View Describe(const Moment& moment);

// "0:00:07" up to "99:59:59"; negative lengths are none.
std::string ClockText(Duration length);

}  // namespace kaori::monitor
