#include "appliance/programs/status/lines.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "appliance/core/board/lines.h"
#include "appliance/core/board/mouth.h"

namespace kaori::status {
namespace {

using board::SourceState;
using namespace std::chrono_literals;

constexpr Duration kLate = 10s;         // A stage that drew nothing for so long draws nothing.
constexpr double kWholeFrom = 10;       // Smaller numbers have a decimal.
constexpr std::size_t kHashShown = 12;  // Digits.

std::string Number(double value) {
  return value < kWholeFrom ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

// So roughly that it seldom changes.
std::string Length(Duration age) {
  if (age < 10s) return "a moment";
  if (age < 1min) return "less than a minute";
  const auto minutes = age / 1min;
  if (minutes == 1) return "a minute";
  if (minutes < 60) return fmt::format("{} minutes", minutes);
  return minutes < 120 ? "an hour" : fmt::format("{} hours", minutes / 60);
}

// Of a frame.
std::string Words(Duration length) {
  return length < 1s ? Number(Seconds(length) * 1e3) + " ms" : Number(Seconds(length)) + " s";
}

Line Title(const Facts& facts) {
  std::string words = facts.profile.empty() ? "not started as a box" : "profile " + facts.profile;
  words += facts.root_hash.empty() ? ", root unchecked" : ", root " + facts.root_hash.substr(0, kHashShown);
  return {Mark::kTitle, "Kaori box", words};
}

Line Show(const board::Stamped<board::StageStatus>& stage, bool has_screen, Time now) {
  if (!has_screen) return {Mark::kFault, "show", "there is no screen to show it on"};
  if (stage.source == SourceState::kAbsent)
    return {Mark::kFault, "show", "no picture yet: the stage is starting"};
  if (now - stage.at > kLate) return {Mark::kFault, "show", "no picture for " + Length(now - stage.at)};
  const board::StageStatus& s = stage.value;
  const std::string late =
      s.missed_flips == 0 ? "none came late" : fmt::format("{} came late", s.missed_flips);
  return {Mark::kGood, "show",
          fmt::format("{} pictures a second, {} each; {}", Number(s.frames_per_s), Words(s.draw), late)};
}

Line Screen(const ports::Output& output) {
  const bool unplugged = output.state == ports::OutputState::kUnplugged;
  return {unplugged ? Mark::kMissing : Mark::kGood, output.connector, ports::DescribeMode(output)};
}

// What a hand's device means to the show when it is not there.
struct Device {
  const char* what;
  const char* pulled;
  const char* absent;
};

Line Of(const Device& device, SourceState source, Time at, Time now) {
  switch (source) {
    case SourceState::kLive:
      return {Mark::kGood, device.what, "there"};
    case SourceState::kStale:
      return {Mark::kMissing, device.what, fmt::format("gone for {}; {}", Length(now - at), device.pulled)};
    case SourceState::kAbsent:
      break;
  }
  return {Mark::kMissing, device.what, fmt::format("not plugged in; {}", device.absent)};
}

template <class T>
Line Of(const Device& device, const board::Stamped<T>& section, Time now) {
  return Of(device, section.source, section.at, now);
}

Line Camera(const board::Stamped<board::Lips>& lips, Time now) {
  Line line = Of({"camera", "the voice has the mouth, or it rests", "the voice has the mouth, or it rests"},
                 lips, now);
  if (lips.source != SourceState::kLive) return line;
  const bool seen = board::IsUsable(lips.value);
  return {seen ? Mark::kGood : Mark::kMissing, "camera",
          seen ? "there, sees the mouth" : "there, sees no painted mouth"};
}

Line Microphone(const board::Stamped<board::Voice>& voice, Time now) {
  Line line =
      Of({"microphone", "the camera alone has the mouth", "the camera alone has the mouth"}, voice, now);
  if (voice.source == SourceState::kLive && voice.value.speaking != 0) line.words = "there, hears a voice";
  return line;
}

Line Loudspeaker(const board::Stamped<board::Sound>& sound, Time now) {
  Line line = Of({"loudspeaker", "the voice is not played", "the voice is not played"}, sound, now);
  if (sound.source == SourceState::kLive)
    line.words = fmt::format("there, {:.0f} ms after the microphone", sound.value.delay_ms);
  return line;
}

Line Lines(const board::Stamped<board::Lines>& lines, Time now) {
  constexpr std::pair<board::Line, const char*> kNames[] = {
      {board::Line::kBlackout, "BLACKOUT"},
      {board::Line::kService, "service"},
      {board::Line::kPresence, "somebody stands before the box"},
      {board::Line::kGo, "GO"}};
  Line line = Of({"switches", "they stand as they were", "the show goes on without them"}, lines, now);
  if (lines.source == SourceState::kAbsent) return line;
  std::string on;
  for (const auto& [which, name] : kNames)
    if (board::IsOn(lines.value, which)) on += std::string(", ") + name;
  line.words += on;
  return line;
}

void AddDevices(const State& state, std::vector<Line>& lines) {
  const auto& b = state.board;
  const Time now = state.now;
  lines.push_back(
      Of({"dial box", "the dials stand where they were", "the face plays by itself"}, b.surface, now));
  lines.push_back(
      Of({"left stick", "the head plays by itself", "the head plays by itself"}, b.sticks[0], now));
  lines.push_back(
      Of({"right stick", "the gaze plays by itself", "the gaze plays by itself"}, b.sticks[1], now));
  lines.push_back(Of({"keyboard", "nothing is typed", "nothing needs it"}, b.keys, now));
  lines.push_back(Camera(b.lips, now));
  lines.push_back(Microphone(b.voice, now));
  lines.push_back(Loudspeaker(state.sound, now));
  lines.push_back(Lines(b.lines, now));
}

}  // namespace

State Look(const board::Board& board, Facts facts, Time now) {
  return {board::ReadAll(board), board.Read<board::Sound>(), std::move(facts), now};
}

std::vector<Line> Describe(const State& state) {
  std::vector<Line> lines{Title(state.facts)};
  for (const std::string& fault : state.facts.faults) lines.push_back({Mark::kFault, "fault", fault});
  lines.push_back(Show(state.board.stage_status, !state.facts.screens.empty(), state.now));
  if (state.facts.screens.empty())
    lines.push_back({Mark::kFault, "screens", "none is plugged in; the show goes on unseen"});
  for (const ports::Output& screen : state.facts.screens) lines.push_back(Screen(screen));
  AddDevices(state, lines);
  return lines;
}

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
