// The lobby of a show: what she does in the foyer by herself, for those who come and for those who leave.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kaori::show {

struct Show;

inline constexpr std::int32_t kDayMinutes = 24 * 60;
inline constexpr std::int32_t kWeekMinutes = 7 * kDayMinutes;
inline constexpr std::size_t kMostLobbyTakes = 64;  // Greetings, or what is said to those who stay.
inline constexpr std::size_t kMostOpenings = 64;    // Of a week.
inline constexpr float kLongestLobby_s = 3600;      // Of every time of a lobby.

// What is said to somebody: a motion with its sound, and the language that it is in.
struct LobbyTake {
  std::string language{};   // A tag as "ja" or "en-GB"; it may be empty.
  std::int32_t motion = 0;  // Of the show's motions; it does not loop.
};

// Minutes since Monday 00:00 in local time: `from` is below kWeekMinutes, `to` lies behind it by a day at
// most, and may be of the next week.
struct OpenSpan {
  std::int32_t from = 0, to = 0;
};

// Times are seconds, 0 .. kLongestLobby_s.
struct Lobby {
  std::uint32_t cue = 0;   // The cue in which she stands in the foyer; its whole chain is played.
  bool by_itself = false;  // The box begins with it and comes back to it; else GO calls it, as any cue.
  std::vector<LobbyTake> greetings{};  // One at least, in turn.
  std::vector<LobbyTake> stays{};      // Said to those who stay, in turn; none: she only looks at them.
  std::vector<LobbyTake> goodbyes{};   // In turn as well; none: she only looks away.
  std::int32_t visitor = 0;            // At whom she looks: of the show's gaze targets.
  float arrive_s = 0.3F;               // The sensor must see somebody so long,
  float leave_s = 4;                   // and nobody so long: it flickers.
  float stuck_s = 1800;           // Who says without a break for so long that somebody is there is stuck.
  float stay_s = 20;              // From one take until the next for somebody who stays.
  float sleep_s = 60;             // She sleeps when nobody has been there for so long.
  float sleep_light = 0.15F;      // 0..1 of the light when she is awake.
  float hand_back_s = 120;        // From an operator's last touch until the lobby has her again.
  std::vector<OpenSpan> hours{};  // Empty: it is always open.
};

// Whether the lobby is open in this minute of the week, 0 .. kWeekMinutes - 1 from Monday 00:00 in local time. Spans
// that run over the end of a week count at its beginning as well. Pure.
bool IsOpenAt(const Lobby& lobby, std::int32_t week_minute);

// Appends what is wrong with the show's lobby, where it has one, a line each, in the manner of CheckShow. What passes
// can be played without any further check. Pure.
void CheckLobby(const Show& show, std::vector<std::string>& faults);

}  // namespace kaori::show
