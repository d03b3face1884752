// What a button or a key calls.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kaori::show {

inline constexpr int kButtonCount = 32;
// Of each of the two sticks.
inline constexpr int kStickButtonCount = 16;
// All buttons are numbered through: those of the dial box, then those of the left and of the right stick.
inline constexpr int kAllButtonCount = kButtonCount + 2 * kStickButtonCount;
inline constexpr std::uint16_t kSheetCount = 2;  // Of buttons.

// `index` of a call is into faces, expressions, styles or scenes, a CueVerb, a sheet, into motions, a Blink,
// or into the cues of the list (kGoTo: a jump to that one).
enum class CallKind : std::uint8_t {
  // A button or a key that does nothing and is not lit.
  kNothing,
  // What joins or takes the place of what is on, each with its own time of fade.
  kFace,
  kExpression,
  kStyle,
  kScene,
  // GO, BACK, PANIC and the rest, as a person at the cue list calls them.
  kCue,
  // Which of the two sheets the buttons of the dial box show.
  kSheet,
  kMotion,
  kBlink,
  kGoTo
};

// Which eyes blink, as they lie before the operator.
enum class Blink : std::uint16_t { kBoth, kLeft, kRight };
inline constexpr std::array<std::string_view, 3> kBlinkNames{"blink", "wink left", "wink right"};

enum class CallMode : std::uint8_t {
  kCall,       // It takes the place of what was called before.
  kToggle,     // It joins that, and a second push lets it go.
  kMomentary,  // It joins that for as long as it is held down.
};
inline constexpr std::array<std::string_view, 3> kCallModeNames{"call", "toggle", "momentary"};

// Whether something of this kind can join others instead of taking their place.
constexpr bool Joins(CallKind kind) {
  return kind == CallKind::kFace || kind == CallKind::kExpression || kind == CallKind::kSheet;
}

// An index that is out of range is a fault of the show, which CheckShow finds.
struct Call {
  CallKind kind = CallKind::kNothing;
  std::uint16_t index = 0;
  CallMode mode = CallMode::kCall;
  friend bool operator==(const Call&, const Call&) = default;
};

}  // namespace kaori::show
