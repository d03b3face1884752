// What a graphics card drives: a connector, the mode that it shows, and what the screen there is for.
#pragma once

#include <cstdint>
#include <string>

namespace kaori::ports {

// Why an output has its mode, for the people who look for a better one: a cable or an adapter that cuts modes off
// shows here first.
enum class ModeOrigin : std::uint8_t {
  kWanted,      // The screen's EDID prefers it, or people asked for it.
  kSubstitute,  // The card refused a better one.
  kSafeGuess,   // The screen prefers no mode: one that every screen and cable carries.
};

// What the screen at an output is used for now. Programs decide by this; texts are for people alone.
enum class OutputState : std::uint8_t {
  kShowsPicture,  // A part of the show's picture is on it.
  kUnplugged,     // Its part of the picture is kept for it; nothing is on it now.
  kShowsStatus,   // It is the status display, and no part of the show.
  kShowsMonitor,  // It is the operators' monitor, and no part of the show either.
};

// Says of one connector what the status display, the desk and the log tell of it. Values only: nothing refers to the
// card, so that it may be kept when the screen is gone.
struct Output {
  std::string connector;  // As KMS names it: "HDMI-A-1". No white space.
  int width_px = 0;       // Of the visible picture.
  int height_px = 0;
  double rate_hz = 0;  // Frames in a second; fields, where the mode is interlaced.
  // Unplugged outputs keep their mode, which is used again when the screen comes back.
  ModeOrigin origin = ModeOrigin::kWanted;
  OutputState state = OutputState::kShowsPicture;
  friend bool operator==(const Output&, const Output&) = default;
};

// The mode, its origin and the state, for people: "1920 x 1080 at 60 Hz, pulled".
std::string DescribeMode(const Output& output);

// The same behind the connector's name: "HDMI-A-1 1920 x 1080 at 60 Hz".
std::string Describe(const Output& output);

}  // namespace kaori::ports
