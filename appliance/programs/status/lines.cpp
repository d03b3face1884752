#include "appliance/programs/status/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "appliance/core/store/said.h"
#include "appliance/programs/status/device_lines.h"

namespace kaori::status {
namespace {

// As the board numbers them.
constexpr std::array<std::string_view, 3> kQualities{"basic", "fine", "finest"};

using board::SourceState;
using namespace std::chrono_literals;

// A stage whose last picture is older shows none any more.
constexpr Duration kLate = 10s;
constexpr double kWholeFrom = 10;       // Smaller numbers are shown with one decimal.
constexpr std::size_t kHashShown = 12;  // How many digits of the hash are shown.

// Two digits that count are enough for people.
std::string Number(double value) {
  return value < kWholeFrom ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

// The time that one frame takes.
std::string FrameTime(Duration length) {
  return length < 1s ? Number(Seconds(length) * 1e3) + " ms" : Number(Seconds(length)) + " s";
}

// A box whose root file system is not verified says so in its first line: nobody can know then what it runs.
Line Title(const Facts& facts) {
  std::string words = facts.name.empty() ? "" : "This box is " + facts.name + ". ";
  words += facts.profile.empty() ? "This program was not started as a box" : "Profile " + facts.profile;
  words += facts.root_hash.empty()
               ? "; the root file system is not verified."
               : "; the root file system is verified, hash " + facts.root_hash.substr(0, kHashShown) +
                     (facts.slot.empty() ? "." : ", slot " + facts.slot + ".");
  return {Mark::kTitle, "Kaori box", words};
}

// From the most basic thing to the finest: a screen, a stage, a picture that is not old, and only then
// figures.
Line Show(const board::Stamped<board::StageStatus>& stage, bool has_screen, Time now) {
  if (!has_screen) return {Mark::kFault, "show", "There is no screen for the picture."};
  if (stage.source == SourceState::kAbsent)
    return {Mark::kFault, "show", "There is no picture yet: the stage is starting."};
  if (now - stage.at > kLate)
    return {Mark::kFault, "show", "There has been no picture for " + Length(now - stage.at) + "."};
  const board::StageStatus& s = stage.value;
  const std::string late =
      s.missed_flips == 0 ? "none was late" : fmt::format("{} were late", s.missed_flips);
  return {Mark::kGood, "show",
          fmt::format("The show has {} frames a second, {} each; {}; {} quality.", Number(s.frames_per_s),
                      FrameTime(s.draw), late,
                      kQualities[std::min<std::size_t>(s.quality, kQualities.size() - 1)])};
}

Line Screen(const ports::Output& output) {
  const bool unplugged = output.state == ports::OutputState::kUnplugged;
  return {unplugged ? Mark::kMissing : Mark::kGood, output.connector, ports::DescribeMode(output)};
}

// The devices in the order in which AddDevices names them.
constexpr std::array<const char*, 9> kCheckedDevices{"dial box",    "left stick", "right stick",
                                                     "keyboard",    "camera",     "microphone",
                                                     "loudspeaker", "switches",   "screens"};

Mark MarkOf(const board::LineCheck& check, std::string_view device) {
  auto worst = board::CheckedState::kSeen;
  for (const board::CheckedItem& item : board::ItemsOf(check))
    if (board::DeviceOf(item) == device) worst = std::min(worst, item.state);
  if (board::Fails(worst)) return Mark::kFault;
  return worst == board::CheckedState::kSeen ? Mark::kGood : Mark::kMissing;
}

// While a check runs its lines stand in the place of the devices', with every control of each.
void AddCheck(const board::LineCheck& check, std::vector<Line>& lines) {
  lines.push_back(
      {Mark::kMissing, "line check",
       fmt::format(
           "{} of {} are seen. Move each control to both ends, first right, forwards, up or clockwise; push "
           "each button; no control moves the face. Home ends the check.",
           board::SeenOf(check), check.count)});
  for (const char* device : kCheckedDevices)
    if (const std::string words = board::PhrasesOf(check, device, false); !words.empty())
      lines.push_back({MarkOf(check, device), device, words + "."});
}

// One that runs and is silent ended with its stage, and says nothing of the devices any more.
bool IsCheckRunning(const State& state) {
  const auto& check = state.board.line_check;
  return check.source == SourceState::kLive && check.value.phase == board::LineCheckPhase::kRunning &&
         state.now - check.at < kLate;
}

// The last one, until the box is switched off: what failed before the house opened is worth knowing in the
// show.
void AddLastCheck(const State& state, std::vector<Line>& lines) {
  const auto& check = state.board.line_check;
  if (check.source != SourceState::kLive || check.value.phase != board::LineCheckPhase::kEnded) return;
  const bool all = board::SeenOf(check.value) == check.value.count;
  lines.push_back(
      {all ? Mark::kGood : Mark::kMissing, "line check",
       fmt::format("It ended {} ago: {}.", Length(state.now - check.at), board::SummaryOf(check.value))});
}

// What is to be done next by whoever teaches at the box; the picture of the show names the level.
std::string TaughtWords(const board::Learn& learn) {
  const std::string control = board::NameOf(learn.found);
  switch (learn.phase) {
    case board::LearnPhase::kFound:
      return control + " was found: Enter keeps it.";
    case board::LearnPhase::kUnfit:
      return control + " springs back, and this level rests at an end: move a slider or a dial.";
    case board::LearnPhase::kKeeping:
      return control + " is being kept.";
    case board::LearnPhase::kKept:
      if (learn.turn_counts != 0) return control + " is kept. Up or Down picks what comes next.";
      return control + " is kept. Up or Down picks what comes next; End starts the stage again with it.";
    case board::LearnPhase::kRefused:
      return control + " could not be kept; the log of the stage says why. Enter tries again.";
    case board::LearnPhase::kNever:
    case board::LearnPhase::kAsking:
    case board::LearnPhase::kEnded:
      break;
  }
  if (learn.restless != 0) return board::NameOf(learn.moves_itself) + " does not rest, and is passed over.";
  return "Move the control or push the button that is to play what the picture names.";
}

// One that is silent ended with its stage.
void AddLearn(const State& state, std::vector<Line>& lines) {
  const auto& [learn, at, source] = state.learn;
  const bool is_over = learn.phase == board::LearnPhase::kNever || learn.phase == board::LearnPhase::kEnded;
  if (source != SourceState::kLive || is_over || state.now - at >= kLate) return;
  const bool fails = learn.phase == board::LearnPhase::kRefused;
  lines.push_back({fails ? Mark::kFault : Mark::kMissing, "learn mode",
                   TaughtWords(learn) + " No control moves the face."});
}

// How often something was refused is told as long as the lock is on: somebody leans on a keyboard.
void AddLock(const board::Stamped<board::ShowNow>& show, std::vector<Line>& lines) {
  if (show.source != SourceState::kLive || show.value.locked == 0) return;
  std::string words = "The show is locked: only those who play are heard. The service key unlocks it.";
  if (show.value.locked_out != 0)
    words += fmt::format(" {} presses or calls were refused.", show.value.locked_out);
  lines.push_back({Mark::kGood, "lock", words});
}

}  // namespace

// Sound, show and learn mode are read by themselves: a snapshot does not have them.
State Look(const board::Board& board, Facts facts, Time now) {
  return {.board = board::ReadAll(board),
          .sound = board.Read<board::Sound>(),
          .show_now = board.Read<board::ShowNow>(),
          .learn = board.Read<board::Learn>(),
          .facts = std::move(facts),
          .now = now};
}

// The order is fixed, so that a line stays in its row of the picture while only its words change.
std::vector<Line> Describe(const State& state) {
  std::vector<Line> lines{Title(state.facts)};
  for (const std::string& fault : state.facts.faults) lines.push_back({Mark::kFault, "fault", fault});
  for (const std::string& notice : state.facts.notices) lines.push_back({Mark::kMissing, "power", notice});
  for (const std::string& said : state.facts.update) lines.push_back({Mark::kMissing, "update", said});
  for (const std::string& said : state.facts.usb) lines.push_back({Mark::kMissing, "refused", said});
  for (const std::string& line : state.facts.shows) {
    const bool refused = line.starts_with(store::kRefusalMark);
    lines.push_back({refused ? Mark::kFault : Mark::kGood, "stick",
                     refused ? line.substr(store::kRefusalMark.size()) : line});
  }
  lines.push_back(Show(state.board.stage_status, !state.facts.screens.empty(), state.now));
  if (state.facts.screens.empty())
    lines.push_back({Mark::kFault, "screens", "No screen is plugged in; the show goes on unseen."});
  for (const ports::Output& screen : state.facts.screens) lines.push_back(Screen(screen));
  AddLock(state.show_now, lines);
  AddLearn(state, lines);
  if (IsCheckRunning(state)) {
    AddCheck(state.board.line_check.value, lines);
  } else {
    AddLastCheck(state, lines);
    AddDevices(state, lines);
  }
  return lines;
}

// The marks are ASCII, for terminals of every kind.
std::string TextOf(const std::vector<Line>& lines) {
  std::string text;
  for (const auto& [mark, what, words] : lines) {
    const char* before = "  ";
    if (mark == Mark::kFault) before = "! ";
    if (mark == Mark::kMissing) before = "- ";
    text += fmt::format("{}{:<12} {}\n", before, what, words);
  }
  return text;
}

}  // namespace kaori::status
