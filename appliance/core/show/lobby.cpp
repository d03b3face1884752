#include "appliance/core/show/lobby.h"

#include <algorithm>

#include <fmt/format.h>

#include "appliance/core/show/show.h"

namespace kaori::show {
namespace {

using LobbyFaults = std::vector<std::string>;

// A take that loops would never let her wait again.
void CheckLobbyTakes(const Show& show, const char* what, const std::vector<LobbyTake>& takes,
                     LobbyFaults& faults) {
  if (takes.size() > kMostLobbyTakes)
    return faults.push_back(
        fmt::format("lobby: {} {}, and {} at most can be played", takes.size(), what, kMostLobbyTakes));
  for (const LobbyTake& take : takes)
    if (take.motion < 0 || take.motion >= static_cast<std::int32_t>(show.motions.size()))
      faults.push_back(fmt::format("lobby: {}: there is no motion {}", what, take.motion));
    else if (show.motions[static_cast<std::size_t>(take.motion)].Loops())
      faults.push_back(fmt::format("lobby: {}: motion {} loops and has no end", what, take.motion));
}

// NaN lies within nothing.
void CheckLobbyTimes(const Lobby& lobby, LobbyFaults& faults) {
  for (const float time_s :
       {lobby.arrive_s, lobby.leave_s, lobby.stuck_s, lobby.stay_s, lobby.sleep_s, lobby.hand_back_s})
    if (!(time_s >= 0 && time_s <= kLongestLobby_s))
      faults.push_back(fmt::format("lobby: a time is {} s, not within 0 to {}", time_s, kLongestLobby_s));
  if (!(lobby.sleep_light >= 0 && lobby.sleep_light <= 1))
    faults.push_back(fmt::format("lobby: its light of sleep is {}, not within 0 to 1", lobby.sleep_light));
}

}  // namespace

// An opening may go on into the next week, so that its minutes are looked for there too.
bool IsOpenAt(const Lobby& lobby, std::int32_t week_minute) {
  const auto covers = [week_minute](const OpenSpan& opening) {
    const auto within = [&](std::int32_t at) { return at >= opening.from && at < opening.to; };
    return within(week_minute) || within(week_minute + kWeekMinutes);
  };
  return lobby.hours.empty() || std::ranges::any_of(lobby.hours, covers);
}

// Cues that Track makes of scenes do not count: a lobby has a cue list of its own.
void CheckLobby(const Show& show, std::vector<std::string>& faults) {
  if (!show.lobby) return;
  const Lobby& lobby = *show.lobby;
  if (show.cue_list.of_scenes || lobby.cue >= show.cue_list.cues.size())
    faults.push_back(fmt::format("lobby: there is no cue {}", lobby.cue));
  if (lobby.greetings.empty()) faults.emplace_back("lobby: it has no greeting");
  CheckLobbyTakes(show, "greetings", lobby.greetings, faults);
  CheckLobbyTakes(show, "stays", lobby.stays, faults);
  CheckLobbyTakes(show, "goodbyes", lobby.goodbyes, faults);
  if (lobby.visitor < 0 || lobby.visitor >= static_cast<std::int32_t>(show.gaze_targets.size()))
    faults.push_back(fmt::format("lobby: there is no gaze target {}", lobby.visitor));
  CheckLobbyTimes(lobby, faults);
  if (lobby.hours.size() > kMostOpenings)
    faults.push_back(
        fmt::format("lobby: {} openings, and {} is the most", lobby.hours.size(), kMostOpenings));
  for (const OpenSpan& opening : lobby.hours)
    if (opening.from < 0 || opening.from >= kWeekMinutes || opening.to <= opening.from ||
        opening.to > opening.from + kDayMinutes)
      faults.push_back(
          fmt::format("lobby: it cannot be open from {} to {} min of the week", opening.from, opening.to));
}

}  // namespace kaori::show
