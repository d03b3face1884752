// The settings of the lips that are made on site, and their text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "appliance/programs/lips/one_euro.h"
#include "appliance/programs/lips/paint_key.h"
#include "appliance/programs/lips/protocol/setting_table.h"
#include "drivers/base/result.h"

namespace kaori::lips {

// The range of an operator's mouth, in widths of the mouth at rest. The four mouth shapes are spread over it.
// Defaults are those of an average mouth; shut is above 0, since painted lips have a height.
struct Extents {
  float shut = 0.28F;    // The height when shut,
  float open = 0.85F;    // and when open as far as it goes.
  float narrow = 0.65F;  // The width when pursed,
  float wide = 1.35F;    // and when stretched.
  friend bool operator==(const Extents&, const Extents&) = default;
};

// How measured sizes become the board's.
struct GaugeSettings {
  // The width of the mouth at rest, in widths of the picture. 0: the board's, or else the median of the first
  // second.
  float rest_width = 0;
  // Of height, width and opening alike.
  OneEuroSettings smoothing;
  Extents extents;
  friend bool operator==(const GaugeSettings&, const GaugeSettings&) = default;
};

// What the desk may change about the voice while it is heard.
struct VoiceSettings {
  float opens_db = -38;  // Of full scale. Louder sound counts as a voice.
  // From the microphone to the loudspeaker. -1: as long as it takes until a picture of the mouth is
  // presented.
  float sound_delay_ms = -1;
  friend bool operator==(const VoiceSettings&, const VoiceSettings&) = default;
};

// A plain value; two that are equal need no saving.
struct LipSettings {
  Paint paint;
  // What counts as paint.
  KeySettings key;
  bool marker = false;  // The operator wears a dot of the same paint on nose or forehead, above the mouth.
  GaugeSettings gauge;
  // What counts as a voice, and how late it is played.
  VoiceSettings voice;
  friend bool operator==(const LipSettings&, const LipSettings&) = default;
};

// The value of the setting with this number; see setting_table.h. `setting` is below kSettingCount.
float ValueOf(const LipSettings& settings, std::size_t setting);

// Returns `settings` with one value changed. Errors:
//   invalid_argument  the name does not exist, the value is out of its range, or shut would not be below open
Result<LipSettings> WithValue(const LipSettings& settings, std::string_view name, float value);

// Returns the settings as text that people can read and change, one line for each value:
//   paint.red = 20
std::string LipSettingsText(const LipSettings& settings);

// Parses such text. What it does not name keeps its default; `name` is what error messages call it. Errors:
//   invalid_argument  a line that is no value, a name that does not exist, a value out of its range, or shut
//                     that is not below open; the message names the line
Result<LipSettings> ParseLipSettings(std::string_view text, const std::string& name);

}  // namespace kaori::lips
