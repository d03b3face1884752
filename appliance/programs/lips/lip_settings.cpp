#include "appliance/programs/lips/lip_settings.h"

#include <array>

#include <fmt/format.h>

#include "drivers/base/number.h"

namespace kaori::lips {
namespace {

// How one setting is read from and written to the struct, as a number. Names and ranges are in
// setting_table.cpp, by the same index: a setting is added in both.
struct Accessor {
  float (*get)(const LipSettings&);
  void (*set)(LipSettings&, float);
};

// Rounded to the nearest level; the ranges of the table keep it within a byte.
std::uint8_t Level(float value) {
  return static_cast<std::uint8_t>(value + 0.5F);
}

#define KAORI_NUMBER(member)                                         \
  [](const LipSettings& s) { return static_cast<float>(s.member); }, \
      [](LipSettings& s, float v) { s.member = v; }
#define KAORI_LEVEL(member)                                          \
  [](const LipSettings& s) { return static_cast<float>(s.member); }, \
      [](LipSettings& s, float v) { s.member = Level(v); }

// In the order of setting_table.cpp.
constexpr std::array kAccessors{
    Accessor{KAORI_LEVEL(paint.red)},
    Accessor{KAORI_LEVEL(paint.green)},
    Accessor{KAORI_LEVEL(paint.blue)},
    Accessor{KAORI_NUMBER(key.similarity)},
    Accessor{KAORI_NUMBER(key.smoothness)},
    Accessor{KAORI_NUMBER(key.spill)},
    Accessor{[](const LipSettings& s) { return s.marker ? 1.0F : 0.0F; },
             [](LipSettings& s, float v) { s.marker = v > 0; }},
    Accessor{KAORI_NUMBER(gauge.rest_width)},
    Accessor{KAORI_NUMBER(gauge.smoothing.least_cutoff_hz)},
    Accessor{KAORI_NUMBER(gauge.smoothing.cutoff_per_speed)},
    Accessor{KAORI_NUMBER(gauge.extents.shut)},
    Accessor{KAORI_NUMBER(gauge.extents.open)},
    Accessor{KAORI_NUMBER(gauge.extents.narrow)},
    Accessor{KAORI_NUMBER(gauge.extents.wide)},
    Accessor{KAORI_NUMBER(voice.opens_db)},
    Accessor{KAORI_NUMBER(voice.sound_delay_ms)},
};

#undef KAORI_NUMBER
#undef KAORI_LEVEL

static_assert(kAccessors.size() == kSettingCount);

// Without blanks at both ends; "\r" is one, for files from other systems.
std::string_view Trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

// Returns the complaint about a value, or nothing. Ranges are checked here and nowhere else, for files,
// commands and tests alike.
std::string SetValue(std::string_view name, float number, LipSettings& into) {
  for (std::size_t setting = 0; setting < kSettingCount; ++setting) {
    const SettingRange range = RangeOf(setting);
    if (range.name != name) continue;
    if (!(number >= range.low && number <= range.high))
      return fmt::format("{} is not between {} and {}", name, range.low, range.high);
    kAccessors[setting].set(into, number);
    return {};
  }
  return fmt::format("there is no setting {}", name);
}

// Ranges alone allow shut and open to cross; narrow and wide cannot, since 1 lies between them.
bool AreBackwards(const Extents& extents) {
  return extents.shut >= extents.open;
}

// Returns the complaint about a line, or nothing.
std::string ParseLine(std::string_view line, LipSettings& into) {
  line = Trimmed(line.substr(0, line.find('#')));
  if (line.empty()) return {};
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) return "a line needs a name, = and a number";
  const std::string_view name = Trimmed(line.substr(0, equals));
  const std::string_view text = Trimmed(line.substr(equals + 1));
  const auto number = ParseNumber<float>(text);
  if (!number) return fmt::format("{} is not a number", text);
  return SetValue(name, *number, into);
}

}  // namespace

// A switch reads as 0 or 1, so that every setting is a number for files, packets and pages.
float ValueOf(const LipSettings& settings, std::size_t setting) {
  return kAccessors[setting].get(settings);
}

// The change is tried on a copy, so that one which is refused leaves nothing behind.
Result<LipSettings> WithValue(const LipSettings& settings, std::string_view name, float value) {
  LipSettings changed = settings;
  const std::string complaint = SetValue(name, value, changed);
  if (!complaint.empty()) return FailInput(complaint);
  if (AreBackwards(changed.gauge.extents)) return FailInput("mouth.shut is not below mouth.open");
  return changed;
}

// fmt writes the shortest text that reads back as the same float.
std::string LipSettingsText(const LipSettings& settings) {
  std::string text = "# Settings of the lips. Lengths are in widths of the mouth at rest.\n";
  for (std::size_t setting = 0; setting < kSettingCount; ++setting)
    text += fmt::format("{} = {}\n", RangeOf(setting).name, ValueOf(settings, setting));
  return text;
}

// A setting that stands twice has its last value.
Result<LipSettings> ParseLipSettings(std::string_view text, const std::string& name) {
  LipSettings settings;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string complaint = ParseLine(text.substr(0, end), settings);
    if (!complaint.empty()) return FailInput(fmt::format("{}:{}: {}", name, number, complaint));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (AreBackwards(settings.gauge.extents))
    return FailInput(fmt::format("{}: mouth.shut is not below mouth.open", name));
  return settings;
}

}  // namespace kaori::lips
