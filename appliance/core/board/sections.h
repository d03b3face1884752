// The board's sections: what each input is now. One program writes each; everyone reads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "drivers/base/clock.h"

namespace kaori::board {

// A source that was never there, is there, or was there and is silent or gone.
enum class SourceState : std::uint32_t { kAbsent, kLive, kStale };

// Values are plain 32-bit words so that they cross the shared memory without tearing types apart.

// The newest presses of a section's buttons or keys, so that a reader that looks seldom still learns which came
// first. Counters alone say how often, but not in which order.
struct PressLog {
  static constexpr std::size_t kKept = 32;  // A power of two, so that `count` may wrap.
  struct Press {
    std::uint32_t code = 0;   // Bits 0 to 7: the button's number or the key's usage; 8 to 15: of a key, which of
                              // the modifiers E0 to E7 were held with it.
    std::uint32_t at_us = 0;  // When it happened, on CLOCK_MONOTONIC; wraps after 71 minutes.
  };
  std::uint32_t count = 0;  // Presses since the board began; wraps.
  std::array<Press, kKept> newest{};  // Press n, counted from 0, lies in newest[n % kKept].
};

// Written by kaori-input.
struct Surface {
  static constexpr const char* kName = "surface";
  std::array<std::int32_t, 8> counts{};  // Dials, accumulated; clockwise is positive.
  std::int32_t counts_per_turn = 256;
  std::uint32_t buttons_down = 0;          // Bit n: button n is held.
  std::array<std::uint32_t, 32> pushes{};  // How often each button went down since the board began.
  PressLog log{};                          // Of the same pushes.
};

// Written by kaori-input; [0] is the left stick (head), [1] the right one (gaze and brows).
struct Stick {
  static constexpr const char* kName = "stick";
  float x = 0;            // -1 left .. 1 right, after dead zone, centre and curve.
  float y = 0;            // -1 pulled back .. 1 pushed forwards.
  float twist = 0;        // -1 counter-clockwise .. 1 clockwise, seen from above.
  float slider = 0;       // 0 .. 1.
  std::int32_t hat = -1;  // 0 up, clockwise in eighths to 7; -1 centred.
  std::uint32_t buttons_down = 0;
  std::array<std::uint32_t, 16> pushes{};
  std::uint32_t port =
      0;  // A hash of where it is plugged in: a restart gives it the same role. 0: nowhere yet.
  // Where X, Y and twist rest on this stick, as it was calibrated; of the device's own way from the middle to
  // the end. A restart goes on with it.
  std::array<float, 3> centres{};
};

// Written by kaori-input. Usages of HID page 7.
struct Keys {
  static constexpr const char* kName = "keys";
  std::array<std::uint32_t, 8> down{};      // Bit u % 32 of word u / 32: the key with usage u is held.
  std::array<std::uint32_t, 256> pushes{};  // How often each went down since the board began.
  PressLog log{};                           // Of the same keys.
};

// Written by kaori-input. A mouse or a tablet: the place on the stage's picture, 0..1 from the left top.
struct Pointer {
  static constexpr const char* kName = "pointer";
  float x = 0.5F;
  float y = 0.5F;
  std::int32_t wheel = 0;                 // Notches since the board began; away from the hand is positive.
  std::uint32_t buttons_down = 0;         // Bit 0: the left one, 1: the right, 2: the middle.
  std::array<std::uint32_t, 3> pushes{};  // How often each button went down since the board began.
};

// Written by kaori-input. GPIO lines.
struct Lines {
  static constexpr const char* kName = "lines";
  std::uint32_t active = 0;
  std::array<std::uint32_t, 16> pushes{};
};

// Written by kaori-lips. Sizes are of the paint's outline, as fractions of the mouth's width at rest: a mouth
// at rest is 1 wide and, shut, about a quarter high.
struct Lips {
  static constexpr const char* kName = "lips";
  float height = 0;
  float width = 1;
  float quality = 0;  // 0 no paint found .. 1 a clean mouth.
  std::uint32_t frames = 0;
  float rest_width = 0;  // In widths of the picture; 0: not yet known. A restart measures on with it.
  float opening = 0;     // Between the lips, inside the paint.
  // How far the operator's left, right corner lies above the mouth's middle. Without a marker a head that
  // leans is told from a crooked mouth by time alone.
  std::array<float, 2> corners{};
  float rest_marker = 0;  // From the marker to the upper lip, in widths of the picture; 0: none was seen.
  // How far this operator's mouth goes: what the four mouth shapes are spread over.
  float shut = 0.28F, open = 0.85F, narrow = 0.65F, wide = 1.35F;
};

// Written by kaori-lips: the voice in the microphone, and the mouth that it would make.
struct Voice {
  static constexpr const char* kName = "voice";
  float level_db = -100;       // Of full scale, smoothed; -100 is silence.
  std::uint32_t speaking = 0;  // 1: the gate is open.
  float height = 0;            // 0 shut .. 1 open,
  float width = 0.5F;          // 0 narrow .. 1 wide, of what the four mouth shapes are spread over.
  float quality = 0;           // 0 no vowel is told .. 1 one alone is likely.
  std::uint32_t blocks = 0;    // Heard since the program began.
};

// Written by kaori-lips: the voice on its way to the loudspeaker, whose state is the section's source.
struct Sound {
  static constexpr const char* kName = "sound";
  float delay_ms = 0;           // From the microphone to the loudspeaker, as it is in use.
  float asked_ms = 0;           // What a hand or the measurement asks for.
  std::uint32_t automatic = 0;  // 1: it is the measurement that asks.
  std::uint32_t xruns = 0;      // How often the loudspeaker ran dry,
  std::uint32_t leaps = 0;      // and how often the voice's place was found anew, with a cross-fade.
  float drift_ppm = 0;          // How much faster the voice is read than it is heard, now.
};

// Written by kaori-stage: the motion that was struck last, for its sound. At the stamp, which is a time of
// light, it stands at `at_s`.
struct MotionNow {
  static constexpr const char* kName = "motion_now";
  std::int32_t take = -1;    // Of the show's takes; -1: none plays.
  float at_s = 0;            // From its beginning.
  std::uint32_t starts = 0;  // Counts the motions that began.
};

// Written by kaori-lips: the calibration that is taken at the box, for the stage's lamps and captions. Live
// while it is under way.
struct LipsGuide {
  static constexpr const char* kName = "lips_guide";
  std::uint32_t step = 0;      // 0 to 3: shut, open, wide, narrow; 4: all are taken, keep them?
  std::uint32_t taking = 0;    // 1: the operator holds the pose and is measured.
  float progress = 0;          // Of the measurement.
  std::uint32_t seen = 0;      // 1: a good mouth is seen now.
  std::uint32_t captions = 0;  // 1: the screen is for whoever works at the box, and may say it in words.
};

// Written by kaori-desk: where its page is, and the code that lets a visitor in. Live while the code is to be
// shown.
struct Desk {
  static constexpr const char* kName = "desk";
  std::uint32_t code = 0;         // Six digits.
  float valid_s = 0;              // From the stamp on.
  std::uint32_t address = 0;      // IPv4, 0xC0A80001 for 192.168.0.1; 0: none.
  std::uint32_t port = 0;         // 0 .. 65535.
  std::uint32_t secure = 0;       // 1: HTTPS.
  std::uint32_t certificate = 0;  // The first four bytes of its SHA-256, big-endian; 0 without HTTPS.
};

// Written by kaori-stage; kaori-input lights the lamps from it.
struct Lamps {
  static constexpr const char* kName = "lamps";
  std::uint32_t lit = 0;
};

// Written by kaori-stage, for people and tests.
struct StageStatus {
  static constexpr const char* kName = "stage_status";
  std::uint32_t frames = 0;
  std::uint32_t missed_flips = 0;
  float frame_cpu_ms = 0;  // Mean of the last second.
  float frames_per_s = 0;
  std::uint32_t face = 0;  // Called last.
  std::uint32_t expression = 0;
  std::uint32_t style = 0;
  std::uint32_t scene = 0;
  std::uint32_t input_age_us = 0;  // Age of the newest input at the last frame's light.
  // Measured at the flips of the last second, means; 0: there was nothing to measure.
  std::uint32_t lips_age_us = 0;   // Age of the lips at the moment of light.
  std::uint32_t voice_age_us = 0;  // Age of the voice at the moment of light.
  // From what the camera sees to the light of a mouth that does the same: the age, half the time that a frame
  // stands, and the mouth's own smoothing. Of the voice where the voice has the mouth.
  std::uint32_t mouth_lag_us = 0;
  // Of the last frame that came to light: the flip, and the moment at which the hands were read for it; on
  // CLOCK_MONOTONIC in ns, low word and high word.
  std::array<std::uint32_t, 2> flip_ns{};
  std::array<std::uint32_t, 2> read_ns{};
  std::uint32_t draw_us = 0;    // The usual time of a frame, from its beginning until the screen has it.
  std::uint32_t margin_us = 0;  // How much earlier than that a frame begins.
};

// Written by kaori-stage for itself: what it needs to go on after a restart without a jump. Opaque to the
// board; see Hold and Restore in performance_state.h.
struct Performance {
  static constexpr const char* kName = "performance";
  static constexpr std::size_t kCapacityBytes = 8192 - 2 * sizeof(std::uint32_t);
  std::uint32_t layout = 0;  // Which struct lies here, as the stage numbers them; 0 is none.
  std::uint32_t bytes = 0;   // How much of `state` is in use.
  std::array<std::uint8_t, kCapacityBytes> state{};
};

// What a reader gets: a value, when it became true, and how its source stands.
template <class T>
struct Stamped {
  T value{};
  Time at{};
  SourceState source = SourceState::kAbsent;
};

}  // namespace kaori::board
