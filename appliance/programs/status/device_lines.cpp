#include "appliance/programs/status/device_lines.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "appliance/core/board/lines.h"
#include "appliance/core/board/mouth.h"

namespace kaori::status {
namespace {

using board::SourceState;
using namespace std::chrono_literals;

// A device, and what the show does without it while it is unplugged or was never there.
struct Device {
  const char* what;
  const char* pulled;
  const char* absent;
};

// A stale section is told as an unplugged device, which is the usual cause of it.
Line Of(const Device& device, SourceState source, Time at, Time now) {
  switch (source) {
    case SourceState::kLive:
      return {Mark::kGood, device.what, "It is plugged in."};
    case SourceState::kStale:
      return {Mark::kMissing, device.what,
              fmt::format("It was unplugged {} ago; {}.", Length(now - at), device.pulled)};
    case SourceState::kAbsent:
      break;
  }
  return {Mark::kMissing, device.what, fmt::format("It is not plugged in; {}.", device.absent)};
}

template <class T>
Line Of(const Device& device, const board::Stamped<T>& section, Time now) {
  return Of(device, section.source, section.at, now);
}

// The same bound as the performance uses, so that what the status says is what the face does.
Line Camera(const board::Stamped<board::Lips>& lips, Time now) {
  Line line =
      Of({"camera", "the voice moves the mouth, or it rests", "the voice moves the mouth, or it rests"}, lips,
         now);
  if (lips.source != SourceState::kLive) return line;
  const bool seen = board::IsUsable(lips.value);
  return {seen ? Mark::kGood : Mark::kMissing, "camera",
          seen ? "It sees the mouth." : "It is plugged in and sees no painted mouth."};
}

// Silence is no fault.
Line Microphone(const board::Stamped<board::Voice>& voice, Time now) {
  Line line =
      Of({"microphone", "the camera alone moves the mouth", "the camera alone moves the mouth"}, voice, now);
  if (voice.source == SourceState::kLive && voice.value.speaking != 0) line.words = "It records a voice.";
  return line;
}

// The delay is the one in use, not the one that was asked for.
Line Loudspeaker(const board::Stamped<board::Sound>& sound, Time now) {
  Line line = Of({"loudspeaker", "the voice is not played", "the voice is not played"}, sound, now);
  if (sound.source == SourceState::kLive)
    line.words = fmt::format("It plays {:.0f} ms after the microphone; it ran dry {} times.",
                             sound.value.delay_ms, sound.value.xruns);
  return line;
}

// By board::Line.
Line Lines(const board::Stamped<board::Lines>& lines, Time now) {
  constexpr std::array<const char*, board::kLineCount> kNames{
      "GO", "BLACKOUT", "service", "somebody is in front of the box", "BACK", "PANIC"};
  Line line = Of({"switches", "all of them count as released", "the show goes on without them"}, lines, now);
  if (lines.source == SourceState::kAbsent) return line;
  std::string on;
  for (std::size_t n = 0; n < kNames.size(); ++n)
    if (board::IsOn(lines.value, static_cast<board::Line>(n))) on += std::string(", ") + kNames[n];
  if (!on.empty()) line.words += " On: " + on.substr(2) + ".";
  return line;
}

}  // namespace

// A span in words, so roughly that it seldom changes.
std::string Length(Duration age) {
  if (age < 10s) return "a moment";
  if (age < 1min) return "less than a minute";
  const auto minutes = age / 1min;
  if (minutes == 1) return "a minute";
  if (minutes < 60) return fmt::format("{} minutes", minutes);
  return minutes < 120 ? "an hour" : fmt::format("{} hours", minutes / 60);
}

// Each with what the show does without it: whoever reads this has to decide whether to mend it now.
void AddDevices(const State& state, std::vector<Line>& lines) {
  const auto& b = state.board;
  const Time now = state.now;
  lines.push_back(
      Of({"dial box", "the dials keep their values", "the face moves by itself"}, b.surface, now));
  lines.push_back(
      Of({"left stick", "the head moves by itself", "the head moves by itself"}, b.sticks[0], now));
  lines.push_back(
      Of({"right stick", "the gaze moves by itself", "the gaze moves by itself"}, b.sticks[1], now));
  lines.push_back(Of({"keyboard", "no key works", "the show does not need it"}, b.keys, now));
  lines.push_back(Camera(b.lips, now));
  lines.push_back(Microphone(b.voice, now));
  lines.push_back(Loudspeaker(state.sound, now));
  lines.push_back(Lines(b.lines, now));
}

}  // namespace kaori::status
