#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>

#include "appliance/authoring/script/show_parts.h"

namespace kaori::authoring {
namespace {

constexpr std::array<const char*, 7> kWeekdays{"monday", "tuesday",  "wednesday", "thursday",
                                               "friday", "saturday", "sunday"};
constexpr std::size_t kLongestLanguageTag = 35;  // As RFC 5646 advises.

// Two digits, a colon, two digits: minutes of the day, of "00:00" to "24:00".
std::optional<std::int32_t> TimeOfDay(std::string_view text) {
  if (text.size() != 5 || text[2] != ':') return std::nullopt;
  std::array<std::int32_t, 2> parts{};
  for (std::size_t i = 0; i < 2; ++i) {
    const char* const at = text.data() + 3 * i;
    const auto [end, error] = std::from_chars(at, at + 2, parts[i]);
    if (error != std::errc() || end != at + 2 || parts[i] < 0) return std::nullopt;
  }
  const std::int32_t minutes = parts[0] * 60 + parts[1];
  return parts[1] < 60 && minutes <= show::kDayMinutes ? std::optional(minutes) : std::nullopt;
}

// "18:00-01:30" of a day; an end that is not behind its beginning is of the next day.
std::optional<show::OpenSpan> SpanOf(std::string_view text, std::int32_t day) {
  if (text.size() != 11 || text[5] != '-') return std::nullopt;
  const auto from = TimeOfDay(text.substr(0, 5)), to = TimeOfDay(text.substr(6));
  if (!from || !to || *from == show::kDayMinutes || *from == *to) return std::nullopt;
  const std::int32_t midnight = day * show::kDayMinutes;
  return show::OpenSpan{midnight + *from, midnight + *to + (*to < *from ? show::kDayMinutes : 0)};
}

void ReadSpan(toml::Section& hours, std::size_t day, const std::string& text,
              std::vector<show::OpenSpan>& into) {
  if (const auto span = SpanOf(text, static_cast<std::int32_t>(day)))
    into.push_back(*span);
  else
    hours.Fault(kWeekdays[day],
                fmt::format("\"{}\" is no time such as \"17:00-23:30\" or \"18:00-01:30\"", text));
}

// A day that is not named is shut; a text, or a list of texts where a day is open more than once.
std::vector<show::OpenSpan> ReadHours(toml::Section hours) {
  hours.AllowOnly(
      {kWeekdays[0], kWeekdays[1], kWeekdays[2], kWeekdays[3], kWeekdays[4], kWeekdays[5], kWeekdays[6]});
  std::vector<show::OpenSpan> open;
  bool says = false;
  for (std::size_t day = 0; day < kWeekdays.size(); ++day) {
    const toml::Value* value = hours.Find(kWeekdays[day]);
    if (value == nullptr) continue;
    const auto texts =
        value->kind == toml::Value::Kind::kText ? std::vector{value->text} : hours.Texts(kWeekdays[day]);
    for (const std::string& text : texts) ReadSpan(hours, day, text, open);
    says = says || !texts.empty();
  }
  if (!says) hours.Fault("", "names no time: without [hours] the lobby is always open");
  if (open.size() > show::kMostOpenings)
    hours.Fault("", fmt::format("has {} openings, and {} is the most", open.size(), show::kMostOpenings));
  return open;
}

// Letters, digits and hyphens: it is shown to people, and sorts the takes of a show.
bool IsLanguageTag(std::string_view tag) {
  return !tag.empty() && tag.size() <= kLongestLanguageTag && std::ranges::all_of(tag, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-';
  });
}

// [[greeting]] and its like: take = "hello" or motion = "nod", and language = "en".
std::vector<show::LobbyTake> ReadLobbyTakes(Script& script, toml::Section& file, const char* key) {
  std::vector<show::LobbyTake> takes;
  for (toml::Section& part : file.Parts(key)) {
    part.AllowOnly({"take", "motion", "language"});
    const char* const named = part.Has("take") ? "take" : "motion";
    if (part.Has("take") && part.Has("motion"))
      part.Fault("take", "stands beside a motion; one of them is played");
    show::LobbyTake take{.language = part.TextOr("language", "")};
    if (part.Has("language") && !IsLanguageTag(take.language))
      part.Fault("language", fmt::format("\"{}\" is no tag such as \"ja\" or \"en-GB\"", take.language));
    const std::string name = part.Text(named);
    if (!name.empty()) take.motion = IndexOf(part, named, named, script.show.motions, name);
    const auto& motions = script.show.motions;
    const auto index = static_cast<std::size_t>(take.motion);
    if (index < motions.size() && motions[index].name == name && motions[index].Loops())
      part.Fault(named, fmt::format("\"{}\" loops and has no end", name));
    takes.push_back(std::move(take));
  }
  if (takes.size() > show::kMostLobbyTakes)
    file.Fault(key, fmt::format("there are {}, and {} is the most", takes.size(), show::kMostLobbyTakes));
  return takes;
}

// By its number, as everywhere.
std::uint32_t CueNumbered(Script& script, toml::Section& file) {
  const std::string number = file.Text("cue");
  const auto& cues = script.show.cue_list.cues;
  const auto found = std::ranges::find(cues, number, &show::Cue::number);
  if (found != cues.end()) return static_cast<std::uint32_t>(found - cues.begin());
  if (!number.empty()) file.Fault("cue", fmt::format("there is no cue \"{}\" in cues.toml", number));
  return 0;
}

bool BeginsByItself(toml::Section& file) {
  const toml::Value* value = file.Find("by_itself");
  if (value == nullptr) return false;
  if (value->kind != toml::Value::Kind::kSwitch) file.Fault("by_itself", "must be true or false");
  return value->on;
}

}  // namespace

void ReadLobbyFile(Script& script, toml::Section file) {
  file.AllowOnly({"cue", "by_itself", "visitor", "arrive_s", "leave_s", "stuck_s", "stay_s", "sleep_s",
                  "sleep_light", "hand_back_s", "greeting", "stay", "goodbye", "hours"});
  const auto seconds = [&file](const char* key, float otherwise, float least) {
    return file.FloatOr(key, otherwise, least, show::kLongestLobby_s, " s");
  };
  show::Lobby lobby;
  lobby.cue = CueNumbered(script, file);
  lobby.by_itself = BeginsByItself(file);
  lobby.visitor = static_cast<std::int32_t>(
      IndexOf(file, "visitor", "gaze target", script.show.gaze_targets, file.TextOr("visitor", "camera")));
  lobby.arrive_s = seconds("arrive_s", lobby.arrive_s, 0);
  lobby.leave_s = seconds("leave_s", lobby.leave_s, 0);
  lobby.stuck_s = seconds("stuck_s", lobby.stuck_s, 60);
  lobby.stay_s = seconds("stay_s", lobby.stay_s, 1);
  lobby.sleep_s = seconds("sleep_s", lobby.sleep_s, 1);
  lobby.hand_back_s = seconds("hand_back_s", lobby.hand_back_s, 1);
  lobby.sleep_light = file.FloatOr("sleep_light", lobby.sleep_light, 0, 1);
  lobby.greetings = ReadLobbyTakes(script, file, "greeting");
  lobby.stays = ReadLobbyTakes(script, file, "stay");
  lobby.goodbyes = ReadLobbyTakes(script, file, "goodbye");
  if (lobby.greetings.empty()) file.Fault("greeting", "there is none; she greets with one at least");
  if (file.Has("hours")) lobby.hours = ReadHours(file.Part("hours"));
  script.show.lobby = std::move(lobby);
}

}  // namespace kaori::authoring
