#include "hw-sim/evening/condition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace kaori::sim {
namespace {

using Kind = Condition::Kind;
using board::LevelOwner;
using board::SourceState;

constexpr float kBlack = 0.999F;            // Of a blackout on its way: all of it.
constexpr double kOfTheRangeIsSame = 0.02;  // A level may be smoothed, and a count of a dial is a part of it.

// Words that stand alone.
constexpr std::pair<std::string_view, Kind> kWords[] = {
    {"refused", Kind::kRefused}, {"unknown", Kind::kUnknown},    {"lost", Kind::kLost},
    {"picture", Kind::kPicture}, {"new-board", Kind::kNewBoard}, {"log-grows", Kind::kLogGrows},
    {"paused", Kind::kPaused},   {"running", Kind::kRunning},    {"panic", Kind::kPanic},
    {"waiting", Kind::kWaiting}, {"dark", Kind::kDark},          {"lit", Kind::kLit},
};

// In the order of board::LevelOwner.
// The words are part of the running order's language: a new owner on the board needs a word here.
constexpr std::array<std::string_view, board::kLevelOwnerCount> kOwners{"nobody", "cue",  "remote",
                                                                        "hand",   "lips", "voice"};

// A cue is named by its number as the show writes it, such as 14.5, which is a text and no number.
// The index is that of the cue list, from 0. After a complaint it is the list's end, and is never used.
int ReadCue(Tokenizer& tokens, const show::Show& show) {
  const auto token = tokens.Next("the number of a cue");
  if (!token) return 0;
  const auto& cues = show.cue_list.cues;
  const auto cue = std::ranges::find(cues, token->text, &show::Cue::number);
  if (cue == cues.end()) tokens.Complain(token->column, fmt::format("the show has no cue {}", token->text));
  return static_cast<int>(cue - cues.begin());
}

// The names are those of show::kLevels, as show files and the log have them.
int ReadLevel(Tokenizer& tokens) {
  const auto token = tokens.Next("the name of a level");
  if (!token) return 0;
  const auto* const level = std::ranges::find(show::kLevels, token->text, &show::LevelInfo::name);
  if (level == show::kLevels.end())
    tokens.Complain(token->column, fmt::format("no level \"{}\"", token->text));
  return static_cast<int>(level - show::kLevels.begin());
}

int ReadOwner(Tokenizer& tokens) {
  const auto token = tokens.Next("nobody, cue, remote, hand, lips or voice");
  if (!token) return 0;
  const auto* const owner = std::ranges::find(kOwners, token->text);
  if (owner == kOwners.end())
    tokens.Complain(token->column, "expected nobody, cue, remote, hand, lips or voice");
  return static_cast<int>(owner - kOwners.begin());
}

// What begins with the name of a port: whether its device is there.
// The screen is refused: it sends nothing that could be live or stale.
void ReadDevice(Tokenizer& tokens, const Token& name, Condition& into) {
  const auto port = DevicePortNamed(name.text);
  if (!port || *port == DevicePort::kScreen)
    return tokens.Complain(name.column, fmt::format("\"{}\" is nothing that can be expected", name.text));
  into.port = *port;
  if (tokens.Accept("live"))
    into.kind = Kind::kLive;
  else if (tokens.Accept("stale"))
    into.kind = Kind::kStale;
  else
    tokens.Complain(tokens.next_column(), "expected live or stale");
}

// The names of devices come last: any word that is not known is told of as a device that does not exist.
void ReadWords(Tokenizer& tokens, const Token& first, const show::Show& show, Condition& into) {
  const auto* const alone =
      std::ranges::find(kWords, first.text, [](const auto& word) { return word.first; });
  if (alone != std::end(kWords)) {
    into.kind = alone->second;
  } else if (first.text == "cue" || first.text == "standby") {
    into.kind = first.text == "cue" ? Kind::kCue : Kind::kStandby;
    into.index = ReadCue(tokens, show);
  } else if (first.text == "mouth") {
    into.kind = Kind::kMouth;
    into.owner = ReadOwner(tokens);
  } else if (first.text == "owner") {
    into.kind = Kind::kOwner;
    into.index = ReadLevel(tokens);
    into.owner = ReadOwner(tokens);
  } else if (first.text == "level") {
    into.kind = Kind::kLevel;
    into.index = ReadLevel(tokens);
    // No level has a range beyond -10 to 10: other numbers are mistakes.
    into.value = tokens.Number("a value in the level's own unit", -10, 10).value_or(0);
  } else {
    ReadDevice(tokens, first, into);
  }
}

// The section that a device's reports come to.
SourceState SourceOf(DevicePort port, const board::Board& board) {
  switch (port) {
    case DevicePort::kDialBox:
      return board.Read<board::Surface>().source;
    case DevicePort::kStickLeft:
      return board.Read<board::Stick>(0).source;
    case DevicePort::kStickRight:
      return board.Read<board::Stick>(1).source;
    case DevicePort::kKeyboard:
      return board.Read<board::Keys>().source;
    case DevicePort::kCamera:
      return board.Read<board::Lips>().source;
    case DevicePort::kPointer:
      return board.Read<board::Pointer>().source;
    case DevicePort::kMicrophone:
      return board.Read<board::Voice>().source;
    case DevicePort::kLoudspeaker:
      return board.Read<board::Sound>().source;
    case DevicePort::kLines:
      return board.Read<board::Lines>().source;
    case DevicePort::kScreen:
      break;  // The reader refuses it.
  }
  return SourceState::kAbsent;
}

// The bits are those of board::kCuesPaused and its neighbours.
bool IsState(const board::ShowNow& now, std::uint32_t bit) {
  return (now.cue_state & bit) != 0;
}

// The tolerance is a part of the level's own range, since levels have different units.
bool LevelIs(const Condition& condition, const board::ShowNow& now) {
  const show::LevelInfo& info = show::kLevels[static_cast<std::size_t>(condition.index)];
  const double is = now.levels[static_cast<std::size_t>(condition.index)].value;
  return std::abs(is - condition.value) <= kOfTheRangeIsSame * (info.high - info.low);
}

// An index below 0 is a list that has not begun; one behind the last cue stands by when the list is over.
std::string CueText(std::int32_t cue, const show::Show& show) {
  const auto& cues = show.cue_list.cues;
  if (cue < 0) return "no cue";
  if (static_cast<std::size_t>(cue) >= cues.size()) return "the end of the list";
  return "cue " + cues[static_cast<std::size_t>(cue)].number;
}

}  // namespace

Condition ReadCondition(Tokenizer& tokens, const show::Show& show) {
  Condition condition;
  const auto first = tokens.Next("what is expected, such as cue 14 or camera stale");
  if (first) ReadWords(tokens, *first, show, condition);
  return condition;
}

Since SinceNow(const board::Board& board, const ShowSeen& seen) {
  const board::ShowNow now = board.Read<board::ShowNow>().value;
  return {now.gos_refused, now.calls_refused, now.calls_lost, board.moves(), seen.pictures, seen.log_bytes};
}

bool Holds(const Condition& condition, const Since& since, const board::Board& board, const ShowSeen& seen) {
  const board::ShowNow now = board.Read<board::ShowNow>().value;
  const auto owner = [&](std::size_t level) { return static_cast<int>(now.levels[level].owner); };
  switch (condition.kind) {
    case Kind::kCue:
      return now.cue_active == condition.index;
    case Kind::kStandby:
      return now.cue_standby == condition.index;
    case Kind::kRefused:
      return now.gos_refused != since.refused;
    case Kind::kUnknown:
      return now.calls_refused != since.unknown;
    case Kind::kLost:
      return now.calls_lost != since.lost;
    case Kind::kPicture:
      return seen.pictures != since.pictures;
    case Kind::kNewBoard:
      // A board that is being replaced is not intact for a moment: only the whole new one counts.
      return board.moves() != since.moves && board.intact();
    case Kind::kLogGrows:
      return seen.log_bytes > since.log_bytes;
    case Kind::kPaused:
      return IsState(now, board::kCuesPaused);
    case Kind::kRunning:
      return !IsState(now, board::kCuesPaused);
    case Kind::kPanic:
      return IsState(now, board::kCuesPanicking);
    case Kind::kWaiting:
      return IsState(now, board::kCuesWaiting);
    case Kind::kDark:
      return seen.blackout >= kBlack;
    case Kind::kLit:
      return seen.blackout <= 1 - kBlack;
    case Kind::kLive:
      return SourceOf(condition.port, board) == SourceState::kLive;
    case Kind::kStale:
      return SourceOf(condition.port, board) == SourceState::kStale;
    case Kind::kMouth:
      return owner(static_cast<std::size_t>(show::Level::kMouthOpen)) == condition.owner;
    case Kind::kOwner:
      return owner(static_cast<std::size_t>(condition.index)) == condition.owner;
    case Kind::kLevel:
      return LevelIs(condition, now);
  }
  return false;
}

std::string Instead(const Condition& condition, const board::Board& board, const show::Show& show) {
  const board::ShowNow now = board.Read<board::ShowNow>().value;
  const auto level = static_cast<std::size_t>(
      condition.kind == Kind::kMouth ? static_cast<int>(show::Level::kMouthOpen) : condition.index);
  switch (condition.kind) {
    case Kind::kCue:
      return CueText(now.cue_active, show) + " is on";
    case Kind::kStandby:
      return CueText(now.cue_standby, show) + " stands by";
    case Kind::kMouth:
    case Kind::kOwner:
      return fmt::format("its owner is {}", kOwners[static_cast<std::size_t>(now.levels[level].owner)]);
    case Kind::kLevel:
      return fmt::format("it is {:.3f}", now.levels[level].value);
    // The other conditions are true or false, and their opposite tells nothing more.
    default:
      return {};
  }
}

}  // namespace kaori::sim
