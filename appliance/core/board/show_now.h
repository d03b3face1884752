// How the show stands: the cue list, who has which level, and from where each role is played. Whoever tells
// people of it, a page, a lamp or a monitor, reads it here and nowhere else.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "drivers/base/clock.h"

namespace kaori::board {

// Bits of ShowNow::cue_state.
enum CueState : std::uint32_t {
  kCuesPaused = 1U << 0U,
  kCuesPanicking = 1U << 1U,
  kCuesBlack = 1U << 2U,    // Blackout was called; the switch's is on its line.
  kCuesWaiting = 1U << 3U,  // The pending cue waits for a person.
};

// Who has a level, as pages tell it. What the lips or the voice do to a mouth is not a level, and they are
// told of here all the same.
enum class LevelOwner : std::uint32_t { kNobody, kCue, kRemote, kRole, kLips, kVoice };
inline constexpr std::uint32_t kLevelOwnerCount = 6;

// Where the lobby stands, as pages tell it; in the order of performance::LobbyPhase.
enum class LobbyState : std::uint32_t { kOff, kAsleep, kWaiting, kGreeting, kWith, kGoodbye, kTakenOver };
inline constexpr std::uint32_t kLobbyStateCount = 7;
// Whether it keeps its opening hours; kClockUnknown: it should, and nobody knows the time of day.
enum class LobbyHours : std::uint32_t { kNone, kOpen, kShut, kClockUnknown };
inline constexpr std::uint32_t kLobbyHoursCount = 4;

// A registered motion or a take that plays.
struct MotionShown {
  std::int32_t motion = -1;  // Of the show's motions; -1: none.
  float at_s = 0;            // From its beginning.
  std::uint32_t ends = 0;    // 1: it is on its way out.
};

// One level in one frame. `role` says something only where kRole is the owner, and lies below
// kMostRoles all the same.
struct LevelShown {
  float value = 0;  // In the level's own unit (show::LevelInfo).
  LevelOwner owner{};
  std::uint32_t role = 0;  // Of the show's roles, where one has it.
};

//   writer   kaori-stage at each frame, seen or not
//   readers  kaori-input, for keys with screens; kaori-lips, which begins no calibration while the show is locked;
//            kaori-report, which sees the list's end; kaori-desk, kaori-shows and kaori-status for people; who shows it to
//            people: in the demo its page; kaori-stage itself when it starts
//   stale    never written so; a stage is taken for dead by the age of the stamp
struct ShowNow {
  static constexpr const char* kName = "show_now";
  static constexpr std::size_t kMostLevels = 32, kMostRoles = 8, kMostMotions = 16;
  // When the act of the active cue began, or the list where it has no acts; Time{}: it has not, or nobody
  // knows.
  Time act_began{};
  // The cue list. Cues count as the show does, from 0.
  std::int32_t cue_active = -1;  // Played last; -1: none was.
  std::int32_t cue_standby = 0;  // What GO plays next; as many as there are cues: the list is over.
  std::int32_t cue_count = 0;    // How many there are.
  // Comes by itself in cue_left_s, or when a person does what it waits for; -1: none.
  std::int32_t cue_pending = -1;
  float cue_left_s = 0;
  std::uint32_t cue_state = 0;    // Bits of CueState.
  std::uint32_t gos_refused = 0;  // Counted since the show opened, as the next two; all wrap.
  std::uint32_t calls_refused = 0;
  std::uint32_t calls_lost = 0;
  std::uint32_t sheet = 0;   // Which sheet of calls the buttons have, from 0.
  std::uint32_t locked = 0;  // 1: only those who play are heard, until the service key is on.
  std::uint32_t locked_out =
      0;  // What the lock has refused, counted since the show opened, as the next one; both wrap.
  std::uint32_t locks_denied = 0;                // The lock was asked for while the service key was on.
  std::array<LevelShown, kMostLevels> levels{};  // In the order of show::Level.
  // By the show's roles: the show::Device from which each is played; one more than the last: nobody plays it.
  std::array<std::uint32_t, kMostRoles> role_devices{};
  std::array<MotionShown, kMostMotions> motions{};  // Those that play, in no order.
  LobbyState lobby{};
  LobbyHours lobby_hours{};
};

}  // namespace kaori::board
