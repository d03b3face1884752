#include <array>
#include <utility>

#include <fmt/format.h>

#include "appliance/authoring/pack/difference_parts.h"

namespace kaori::authoring {
namespace {

using show::Lobby;

// As lobby.toml names them.
// All but sleep_light are seconds; that one is the light while she sleeps, as a part of the full light.
constexpr std::array<std::pair<const char*, float Lobby::*>, 7> kLobbyTimes{
    {{"arrive_s", &Lobby::arrive_s},
     {"leave_s", &Lobby::leave_s},
     {"stuck_s", &Lobby::stuck_s},
     {"stay_s", &Lobby::stay_s},
     {"sleep_s", &Lobby::sleep_s},
     {"sleep_light", &Lobby::sleep_light},
     {"hand_back_s", &Lobby::hand_back_s}}};
// Minutes of the week count from Monday 00:00, so that a day's index is its minute divided by kDayMinutes.
constexpr std::array<const char*, 7> kDays{"monday", "tuesday",  "wednesday", "thursday",
                                           "friday", "saturday", "sunday"};

// "nothing" for a number that no item has, so that two packs can be compared whatever they hold.
std::string LobbyCueOf(const show::Show& show) {
  const auto& cues = show.cue_list.cues;
  return show.lobby->cue < cues.size() ? cues[show.lobby->cue].number : "nothing";
}

// A visitor below 0 is none: the lobby then has no target for her gaze.
std::string VisitorOf(const show::Show& show) {
  const auto index = static_cast<std::size_t>(show.lobby->visitor);
  return show.lobby->visitor >= 0 && index < show.gaze_targets.size() ? show.gaze_targets[index].name
                                                                      : "nothing";
}

// "hello (en), bow"; "none".
// The language is a tag such as "ja" or "en-GB", and may be empty.
std::string TakesOf(const show::Show& show, const std::vector<show::LobbyTake>& takes) {
  std::string words;
  for (const show::LobbyTake& take : takes) {
    const auto index = static_cast<std::size_t>(take.motion);
    const bool known = take.motion >= 0 && index < show.motions.size();
    words += (words.empty() ? "" : ", ") + (known ? show.motions[index].name : "nothing");
    if (!take.language.empty()) words += " (" + take.language + ")";
  }
  return words.empty() ? "none" : words;
}

// "friday 17:00-01:30, ..."; "always".
std::string HoursOf(const Lobby& lobby) {
  const auto time = [](std::int32_t minute) {
    // An opening may end on the next day: the day that is told is that of its beginning.
    return fmt::format("{:02}:{:02}", minute / 60 % 24, minute % 60);
  };
  std::string words;
  for (const show::OpenSpan& opening : lobby.hours) {
    const auto day = static_cast<std::size_t>(opening.from / show::kDayMinutes);
    words += fmt::format("{}{} {}-{}", words.empty() ? "" : ", ", day < kDays.size() ? kDays[day] : "no day",
                         time(opening.from), time(opening.to));
  }
  return words.empty() ? "always" : words;
}

}  // namespace

// Numbers are compared as they are told, to a hundredth: what reads the same is no difference.
void CompareLobby(const show::Show& a, const show::Show& b, Lines& lines) {
  // A show without a lobby.toml has none, and then there is nothing to compare.
  if (!a.lobby && !b.lobby) return;
  if (!a.lobby || !b.lobby) {
    lines.emplace_back(a.lobby ? "lobby: is gone" : "lobby: is new");
    return;
  }
  const auto compare = [&](const char* what, const std::string& before, const std::string& after) {
    if (before != after) lines.push_back(fmt::format("lobby: {} {} is now {}", what, before, after));
  };
  compare("cue", LobbyCueOf(a), LobbyCueOf(b));
  compare("by_itself", a.lobby->by_itself ? "true" : "false", b.lobby->by_itself ? "true" : "false");
  compare("visitor", VisitorOf(a), VisitorOf(b));
  for (const auto& [name, value] : kLobbyTimes)
    compare(name, fmt::format("{:.2f}", *a.lobby.*value), fmt::format("{:.2f}", *b.lobby.*value));
  compare("greeting", TakesOf(a, a.lobby->greetings), TakesOf(b, b.lobby->greetings));
  compare("stay", TakesOf(a, a.lobby->stays), TakesOf(b, b.lobby->stays));
  compare("goodbye", TakesOf(a, a.lobby->goodbyes), TakesOf(b, b.lobby->goodbyes));
  compare("hours", HoursOf(*a.lobby), HoursOf(*b.lobby));
}

}  // namespace kaori::authoring
