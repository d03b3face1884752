// The line check: before the house opens every control of every device that the show uses is moved once, and
// the box says which of them work.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace kaori::board {

// What is looked at. `device` and `number` of a CheckedItem are as each says, and 0 where nothing is said.
enum class CheckedKind : std::uint32_t {
  kAxis,  // Of a stick; `device` and `number` are a show::Device and a show::Control.
  kDial,  // Of the dial box or what plays in its place; `number` counts from 0, as in the kinds that follow.
  kButton,
  kSwitch,    // A GPIO line; `number` is its board::Line.
  kKeyboard,  // Any key of it.
  kCamera,
  kMicrophone,
  kLoudspeaker,
  kLamps,   // All of them together: no box can see them, so that a person says that they were lit.
  kScreen,  // `number` counts in the order of the picture's parts.
};
inline constexpr std::uint32_t kCheckedKindCount = 10;

// Those that fail come first, the worst of them before the others.
enum class CheckedState : std::uint32_t {
  kMissing,  // Its device is not plugged in.
  kNoisy,  // It jitters as no person moves it, or chatters; a microphone that is never quiet, a loudspeaker that runs dry.
  kStuck,  // It stays down, or off its middle; a camera or a microphone whose counts stand still.
  kShort,  // It was moved and has not been at both ends.
  kUnseen,  // Nobody has moved it yet.
  kSeen,
};
inline constexpr std::uint32_t kCheckedStateCount = 6;

// One control, device or screen of the list, and how it stands.
struct CheckedItem {
  CheckedKind kind{};
  std::uint32_t device = 0;
  std::uint32_t number = 0;
  CheckedState state = CheckedState::kUnseen;
  // As far as it has been: an axis -1..1 or 0..1, a dial in turns from where it stood, lips 0 shut .. 1 open,
  // a voice in dB of full scale. Others: 0.
  float low = 0, high = 0;
  // 1: its lower end (left, back, down, counter-clockwise) was reached first. Whoever moved it to the other
  // end first has a control that is reversed.
  std::uint32_t low_first = 0;
};

// A check is begun and ended by a person (LineCheckCall). What the last one found stays until the next begins.
enum class LineCheckPhase : std::uint32_t { kNever, kRunning, kEnded };

//   writer   kaori-stage at each frame while a check runs, and once when it has ended
//   readers  kaori-stage for its log; kaori-shows, whose list waits meanwhile; kaori-desk and kaori-status for people; who
//            shows it to people: in the demo its page
//   stale    never written so; a check that runs and is silent ended with its stage
struct LineCheck {
  static constexpr const char* kName = "line_check";
  static constexpr std::size_t kMostItems = 112;
  LineCheckPhase phase = LineCheckPhase::kNever;
  std::uint32_t count = 0;  // Of the items that are in use.
  std::array<CheckedItem, kMostItems> items{};
};

// The items in use.
inline std::span<const CheckedItem> ItemsOf(const LineCheck& check) {
  return std::span(check.items).first(check.count);
}

// Whether it would fail a show; what was not seen is not known.
constexpr bool Fails(CheckedState state) {
  return state < CheckedState::kUnseen;
}

// How many were seen and do not fail.
std::size_t SeenOf(const LineCheck& check);

// The device of an item, for people: "left stick", "dial box", "switches".
std::string_view DeviceOf(const CheckedItem& item);

// One item within its device, with how it stands: "twist short way, -0.40 to 1.00", "button 7 stuck".
std::string PhraseOf(const CheckedItem& item);

// The items of one device, or of all where it is empty, those that fail first; dials and buttons that stand
// alike are named together: "buttons 3-7, 9 not yet seen". All: with their devices' names. `failing`: those
// that were seen are left out.
std::string PhrasesOf(const LineCheck& check, std::string_view device, bool failing);

// In one line what failed: "41 of 43 work; left stick twist short way, -0.40 to 1.00; button 7 not yet seen".
std::string SummaryOf(const LineCheck& check);

}  // namespace kaori::board
