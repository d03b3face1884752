// The board's sections: what each input is now, and what the programs tell each other. One program writes
// each; any program may read each, at any time and as often as it likes.
//
// Each value is stamped with the time at which it became true and with the state of its source. Counters
// count on from the board's beginning, over restarts of their writers, and wrap: readers look at differences.
// valid.h says which values are possible; readers pass over others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "appliance/core/board/button_calls.h"
#include "appliance/core/board/calls.h"
#include "appliance/core/board/learn.h"
#include "appliance/core/board/line_check.h"
#include "appliance/core/board/show_now.h"
#include "appliance/core/board/shows_menu.h"
#include "drivers/base/clock.h"

namespace kaori::board {

// Whether the source of a value was never there (kAbsent), is there (kLive), or was there and is silent or
// gone (kStale). A section that nobody has written reads as kAbsent. kStale keeps the last value where that
// is of use: each section says what its writer leaves.
enum class SourceState : std::uint32_t { kAbsent, kLive, kStale };

// Values are plain words without pointers, so that they mean the same in every process.

// The newest presses of a section's buttons or keys, so that a reader that looks seldom still learns which
// came first. Counters alone say how often, but not in which order. A reader that remembers `count` of its
// last look reads the presses from there to the newest `count`; where more than kKept lie between, the older
// ones are lost and only counted.
struct PressLog {
  static constexpr std::size_t kKept = 32;  // A power of two, so that `count` may wrap.
  struct Press {
    // Bits 0 to 7: the button's number or the key's usage. Bits 8 to 15, of a key: which of the modifiers E0
    // to E7 were held with it.
    std::uint32_t code = 0;
    std::uint32_t at_us = 0;  // When it happened, on CLOCK_MONOTONIC; wraps after 71 minutes.
  };
  std::uint32_t count = 0;            // Presses since the board began; wraps.
  std::array<Press, kKept> newest{};  // Press n, counted from 0, lies in newest[n % kKept].
};

// The control surface: eight dials and 32 buttons.
//   writer   kaori-input, at each report of the device, up to 1000 times a second, and when it comes or goes
//   readers  kaori-stage at each frame; kaori-lips, for its calibration, every 25 ms; kaori-shows, for its list; kaori-desk
//            and kaori-status for people; kaori-input itself when it starts
//   stale    the box is unplugged: all buttons are released, dials keep their counts
// The counts go on over plugs and restarts, wherever the dials themselves stand: only differences mean
// something.
struct Surface {
  static constexpr const char* kName = "surface";
  std::array<std::int32_t, 8> counts{};  // Dials, accumulated; clockwise is positive.
  // From the settings, 1 .. 2^20: a difference of this many counts is one turn.
  std::int32_t counts_per_turn = 256;
  std::uint32_t buttons_down = 0;          // Bit n: button n is held.
  std::array<std::uint32_t, 32> pushes{};  // How often each button went down since the board began.
  PressLog log{};                          // Of the same pushes.
};

// A stick: [0] is the left one, which moves the head, [1] the right one, which moves gaze and brows.
//   writer   kaori-input, at each report of the device
//   readers  kaori-stage at each frame; kaori-desk, kaori-shows and kaori-status for people; kaori-input itself when it starts
//   stale    unplugged, or plugged in again and silent: axes as they were, buttons and hat released. Readers
//            hold the axes for 0.25 s and then ease them to neutral
struct Stick {
  static constexpr const char* kName = "stick";
  float x = 0;            // -1 left .. 1 right, after dead zone, centre and curve.
  float y = 0;            // -1 pulled back .. 1 pushed forwards.
  float twist = 0;        // -1 counter-clockwise .. 1 clockwise, seen from above.
  float slider = 0;       // 0 .. 1.
  std::int32_t hat = -1;  // 0 up, clockwise in eighths to 7; -1 centred.
  // Bit n: button n is held, counted from 0; of a stick with more than 16 only the first 16 are counted as pushes.
  std::uint32_t buttons_down = 0;
  std::array<std::uint32_t, 16> pushes{};
  PressLog log{};  // Of the same pushes; codes are below 16.
  // A hash of the name of the port where it is plugged in (programs/input/stick_roles.h), so that a restart
  // of kaori-input gives the stick the same role. 0: it was nowhere yet.
  std::uint32_t port = 0;
  // Where X, Y and twist rest on this stick, as it was calibrated; of the device's own way from the middle to
  // the end. A restart goes on with it.
  std::array<float, 3> centres{};
};

// The keyboard, by usages of HID page 7.
//   writer   kaori-input, at each report of the device
//   readers  kaori-stage at each frame; kaori-lips, for its calibration, every 25 ms; kaori-shows, for its list; kaori-desk
//            and kaori-status for people; kaori-input itself when it starts
//   stale    unplugged: every key is released, counters stay
struct Keys {
  static constexpr const char* kName = "keys";
  std::array<std::uint32_t, 8> down{};      // Bit u % 32 of word u / 32: the key with usage u is held.
  std::array<std::uint32_t, 256> pushes{};  // How often each went down since the board began.
  PressLog log{};                           // Of the same keys.
};

// A mouse or a tablet: its position on the stage's picture, 0..1 from the left top.
//   writer   kaori-input, at each report of the device
//   readers  kaori-stage at each frame, for the expression editor; kaori-input itself when it starts
//   stale    unplugged: buttons are released, the position stays
struct Pointer {
  static constexpr const char* kName = "pointer";
  float x = 0.5F;
  float y = 0.5F;
  std::int32_t wheel = 0;          // Notches since the board began; away from the operator is positive.
  std::uint32_t buttons_down = 0;  // Bit 0: the left one, 1: the right, 2: the middle.
  std::array<std::uint32_t, 3> pushes{};  // How often each button went down since the board began.
};

// A bit for each line that lines.h names.
inline constexpr std::uint32_t kEveryLine = 0x3F;

// GPIO lines, numbered as in lines.h.
//   writer   kaori-input, at each edge of a line, once it no longer bounces
//   readers  kaori-stage at each frame; kaori-lips every 25 ms; for the service key kaori-data, kaori-power, kaori-report,
//            kaori-shows and kaori-surface; kaori-desk and kaori-status for people; kaori-input itself, for the tally lamp
//   stale    the chip is gone: every line is released. The stage keeps a blackout until a scene is called
struct Lines {
  static constexpr const char* kName = "lines";
  std::uint32_t active = 0;                // Bit n: line n is active.
  std::array<std::uint32_t, 16> pushes{};  // How often each became active since the board began.
  std::uint32_t wired = kEveryLine;        // Bit n: line n is wired on this box.
};

// The operator's painted lips before the camera. Sizes are of the paint's outline, as fractions of the
// mouth's width at rest: a mouth at rest is 1 wide and, shut, about a quarter high. The stamp is the middle
// of the exposure.
//   writer   kaori-lips, at each picture of the camera, 30 or 60 times a second
//   readers  kaori-stage at each frame; kaori-desk, kaori-shows and kaori-status for people; kaori-lips itself when it starts
//   stale    the camera is gone or sends nothing: the mouth as it was last. The voice takes over
// Live with a quality of 0 means that the camera works and finds no paint.
struct Lips {
  static constexpr const char* kName = "lips";
  // Height and width of the paint's outline, 0 .. 8 each.
  float height = 0;
  float width = 1;
  float quality = 0;         // 0 no paint found .. 1 a clean mouth.
  std::uint32_t frames = 0;  // Pictures that were read since the program began.
  float rest_width = 0;      // In widths of the picture; 0: not yet known. A restart measures on with it.
  float opening = 0;         // Between the lips, inside the paint.
  // How far the operator's left, right corner lies above the mouth's middle. Without a marker a head that
  // leans is told from a crooked mouth by time alone.
  std::array<float, 2> corners{};
  float rest_marker = 0;  // From the marker to the upper lip, in widths of the picture; 0: none was seen.
  // How far this operator's mouth goes: what the four mouth shapes are spread over.
  float shut = 0.28F, open = 0.85F, narrow = 0.65F, wide = 1.35F;
};

// The voice in the microphone, and the mouth that it would make.
//   writer   kaori-lips, at each block of sound, every 5 to 10 ms
//   readers  kaori-stage at each frame; kaori-desk, kaori-shows and kaori-status for people
//   stale    the microphone is gone: the face's own expression gets the mouth back
struct Voice {
  static constexpr const char* kName = "voice";
  float level_db = -100;       // Of full scale, smoothed; -100 is silence.
  std::uint32_t speaking = 0;  // 1: the gate is open.
  float height = 0;            // 0 shut .. 1 open,
  float width = 0.5F;          // 0 narrow .. 1 wide, of what the four mouth shapes are spread over.
  float quality = 0;           // 0 no vowel is told .. 1 one alone is likely.
  std::uint32_t blocks = 0;    // Heard since the program began.
};

// The voice on its way to the loudspeaker, whose state is the section's source.
//   writer   kaori-lips, 10 times a second, and when the loudspeaker goes
//   readers  kaori-stage in a line check; kaori-desk, kaori-shows and kaori-status for people; kaori-lips itself when it starts
//   stale    the loudspeaker is gone; figures are the last ones
struct Sound {
  static constexpr const char* kName = "sound";
  float delay_ms = 0;           // From the microphone to the loudspeaker, as it is in use.
  float asked_ms = 0;           // What a person or the measurement asks for.
  std::uint32_t automatic = 0;  // 1: it is the measurement that asks.
  std::uint32_t xruns = 0;      // How often the loudspeaker ran dry,
  std::uint32_t leaps = 0;      // and how often the voice's place was found anew, with a cross-fade.
  float drift_ppm = 0;          // How much faster the voice is read than it is heard, now.
};

// The motion whose sound is to be heard: of those that play one at most has one. At the stamp, which
// is when a frame is presented, it stands at `at_s`.
//   writer   kaori-stage at each frame while one plays, and once when it has ended
//   readers  kaori-lips, which plays its sound; kaori-stage itself when it starts
// The stage leaves the last value when it ends, so a reader compares stamp and `at_s` with its own clock.
struct MotionNow {
  static constexpr const char* kName = "motion_now";
  std::int32_t motion = -1;  // Of the show's motions; -1: none plays.
  float at_s = 0;            // From its beginning.
  std::uint32_t starts = 0;  // Counts the motions that began.
};

// The calibration of the lips that is under way at the box. Absent while there is none.
//   writer   kaori-lips every 25 ms while it is under way, so that a silent one is seen to be over
//   readers  kaori-stage at each frame, for its lamps and captions; kaori-shows, whose list waits meanwhile
struct LipsGuide {
  static constexpr const char* kName = "lips_guide";
  std::uint32_t step = 0;      // 0 to 3: shut, open, wide, narrow; 4: all are measured, shall they be kept?
  std::uint32_t taking = 0;    // 1: the operator holds the pose and is measured.
  float progress = 0;          // Of the measurement.
  std::uint32_t seen = 0;      // 1: a good mouth is seen now.
  std::uint32_t captions = 0;  // 1: the screen is for whoever works at the box, and may say it in words.
};

// Where the desk's page is, and the code by which a visitor is authorised. Live while the code is to be shown.
//   writer   kaori-desk, about once a second while the code is shown
//   readers  kaori-stage at each frame, for its caption
struct Desk {
  static constexpr const char* kName = "desk";
  std::uint32_t code = 0;         // Six digits.
  float valid_s = 0;              // From the stamp on.
  std::uint32_t address = 0;      // IPv4, 0xC0A80001 for 192.168.0.1; 0: none.
  std::uint32_t port = 0;         // 0 .. 65535.
  std::uint32_t secure = 0;       // 1: HTTPS.
  std::uint32_t certificate = 0;  // The first four bytes of its SHA-256, big-endian; 0 without HTTPS.
};

// The last messages of the MIDI devices, for people who want to know what a surface sends.
//   writer   kaori-input, when messages have come
//   readers  who shows it to people: in the demo its page; kaori-input itself when it starts
//   stale    never written so
struct MidiHeard {
  static constexpr const char* kName = "midi_heard";
  static constexpr std::size_t kKept = 16;  // A power of two, so that `count` may wrap.
  static constexpr std::uint32_t kNothing = 0xFF;
  struct Message {
    std::uint32_t at_ms = 0;   // On CLOCK_MONOTONIC; wraps after 49 days.
    std::uint32_t device = 0;  // Vendor and product of the USB device, the vendor in the upper half.
    // Status, number and value as they came, in bits 0 to 23; a note-on of velocity 0 is one here too.
    std::uint32_t bytes = 0;
    // What it was for: in bits 0 to 7 the board's dial, in bits 8 to 15 its button; kNothing: none.
    std::uint32_t meant = kNothing | kNothing << 8U;
  };
  std::uint32_t count = 0;              // Messages since the board began; wraps.
  std::array<Message, kKept> newest{};  // Message n, counted from 0, lies in newest[n % kKept].
};

// The lamps in the buttons of the control surface.
//   writer   kaori-stage, when they change
//   readers  kaori-input every 5 ms, which lights them; kaori-stage itself at each frame, which writes another state alone
// Never stale: kaori-input lights what stands here until a stage writes something else.
struct Lamps {
  static constexpr const char* kName = "lamps";
  std::uint32_t lit = 0;  // Bit n: the lamp of button n is lit.
};

// How the stage does.
//   writer   kaori-stage at each frame; means once a second
//   readers  kaori-lips for the voice's delay; kaori-input for the tally lamp; kaori-shows and kaori-update, whose work beside
//            the face rests by it; kaori-surface, which asks whether a show runs; kaori-desk and kaori-status for people; who
//            shows it to people: in the demo its page; kaori-stage itself when it starts
//   stale    never written so; a stage is taken for dead by the age of the stamp
struct StageStatus {
  static constexpr const char* kName = "stage_status";
  // Of the last frame that was presented: the flip, and when the input was sampled for it.
  Time flipped_at{};
  Time sampled_at{};
  Duration input_age{};  // Age of the newest input when the last frame is presented.
  Duration draw{};       // The usual time of a frame, from its beginning until the screen has it.
  Duration margin{};     // How much earlier than that a frame begins.
  Duration frame_cpu{};  // Processor time of a frame: mean of the last second.
  // Measured at the flips of the last second, means; 0: there was nothing to measure.
  Duration lips_age{};   // Age of the lips when they are presented.
  Duration voice_age{};  // Age of the voice when it is presented.
  // From what the camera sees until the screen shows a mouth that does the same: the age, half the time that
  // a frame stands, and the mouth's own smoothing. Of the voice where the voice has the mouth.
  Duration mouth_lag{};
  // Frames since the board began; flips that this stage has missed since it started.
  std::uint32_t frames = 0;
  std::uint32_t missed_flips = 0;
  // Mean of the last second; 0 in the first one.
  float frames_per_s = 0;
  std::uint32_t face = 0;  // Called last, as the next three.
  std::uint32_t expression = 0;
  std::uint32_t style = 0;
  std::uint32_t scene = 0;
  std::uint32_t quality = 0;  // How finely it draws (render/passes/quality.h): 0 basic, 1 fine, 2 finest.
};

// What the stage needs to go on after a restart without a jump. Opaque to the board; see Hold and Restore in
// performance_state.h.
//   writer   kaori-stage at each frame
//   readers  kaori-stage when it starts; tests
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
