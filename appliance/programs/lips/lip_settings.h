// What is set about the lips on site, and the file that keeps it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "appliance/programs/lips/one_euro.h"
#include "appliance/programs/lips/paint_key.h"
#include "drivers/base/result.h"

namespace kaori::lips {

// How far an operator's mouth goes, in widths of the mouth at rest: heights shut and open, widths pursed and
// stretched. The four mouth shapes are spread over it.
struct Extents {
  float shut = 0.28F;
  float open = 0.85F;
  float narrow = 0.65F;
  float wide = 1.35F;
  friend bool operator==(const Extents&, const Extents&) = default;
};

struct GaugeSettings {
  float rest_width = 0;  // In widths of the picture; 0: as the board has it, else the first second's median.
  OneEuroSettings smoothing;
  Extents extents;
  friend bool operator==(const GaugeSettings&, const GaugeSettings&) = default;
};

struct VoiceSettings {
  float opens_db = -38;  // Of full scale: what is louder is a voice.
  // From the microphone to the loudspeaker; -1: as long as the mouth takes to the light, as measured.
  float sound_delay_ms = -1;
  friend bool operator==(const VoiceSettings&, const VoiceSettings&) = default;
};

struct LipSettings {
  Paint paint;
  KeySettings key;
  bool marker = false;  // A dot of the same paint is worn on nose or forehead, straight above the mouth.
  GaugeSettings gauge;
  VoiceSettings voice;
  friend bool operator==(const LipSettings&, const LipSettings&) = default;
};

// The values one by one, in the order in which the text names them.
inline constexpr std::size_t kSettingCount = 16;
struct SettingRange {
  std::string_view name;
  float low;
  float high;
};
SettingRange RangeOf(std::size_t setting);
float ValueOf(const LipSettings& settings, std::size_t setting);

// `settings` with one value changed. Errors:
//   invalid_argument  a name that does not exist, a value out of its range, or extents that go backwards
Result<LipSettings> WithValue(const LipSettings& settings, std::string_view name, float value);

// As text that people can read and change, one line for each value:
//   paint.red = 20
std::string LipSettingsText(const LipSettings& settings);

// What `text` does not name stays as above; `name` is what complaints call it. Errors:
//   invalid_argument  a line that is no value, a name that does not exist, a value out of its range, or
//                     extents that go backwards: the attempt names the line
Result<LipSettings> ParseLipSettings(std::string_view text, const std::string& name);

// Errors: those of the file, and as above.
Result<LipSettings> ReadLipSettings(const std::filesystem::path& file);

// The file holds all of it or what it held before, whenever the power goes. Blocks for the disk. Errors:
// those of the file.
Result<void> WriteLipSettings(const std::filesystem::path& file, const LipSettings& settings);

}  // namespace kaori::lips
