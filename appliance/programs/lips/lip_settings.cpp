#include "appliance/programs/lips/lip_settings.h"

#include <array>
#include <cerrno>
#include <charconv>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::lips {
namespace {

// One value of the file, as a number.
struct Value {
  std::string_view name;
  float low;
  float high;
  float (*get)(const LipSettings&);
  void (*set)(LipSettings&, float);
};

std::uint8_t Level(float value) {
  return static_cast<std::uint8_t>(value + 0.5F);
}

#define KAORI_NUMBER(member)                                         \
  [](const LipSettings& s) { return static_cast<float>(s.member); }, \
      [](LipSettings& s, float v) { s.member = v; }
#define KAORI_LEVEL(member)                                          \
  [](const LipSettings& s) { return static_cast<float>(s.member); }, \
      [](LipSettings& s, float v) { s.member = Level(v); }

constexpr std::array kValues{
    Value{"paint.red", 0, 255, KAORI_LEVEL(paint.red)},
    Value{"paint.green", 0, 255, KAORI_LEVEL(paint.green)},
    Value{"paint.blue", 0, 255, KAORI_LEVEL(paint.blue)},
    Value{"key.similarity", 1, 1000, KAORI_NUMBER(key.similarity)},
    Value{"key.smoothness", 1, 1000, KAORI_NUMBER(key.smoothness)},
    Value{"key.spill", 1, 1000, KAORI_NUMBER(key.spill)},
    Value{"marker", 0, 1, [](const LipSettings& s) { return s.marker ? 1.0F : 0.0F; },
          [](LipSettings& s, float v) { s.marker = v > 0; }},
    Value{"rest_width", 0, 0.95F, KAORI_NUMBER(gauge.rest_width)},
    Value{"smoothing.least_cutoff_hz", 0.1F, 100, KAORI_NUMBER(gauge.smoothing.least_cutoff_hz)},
    Value{"smoothing.cutoff_per_speed", 0, 1000, KAORI_NUMBER(gauge.smoothing.cutoff_per_speed)},
    Value{"mouth.shut", 0, 2, KAORI_NUMBER(gauge.extents.shut)},
    Value{"mouth.open", 0.05F, 4, KAORI_NUMBER(gauge.extents.open)},
    Value{"mouth.narrow", 0.1F, 0.99F, KAORI_NUMBER(gauge.extents.narrow)},
    Value{"mouth.wide", 1.01F, 4, KAORI_NUMBER(gauge.extents.wide)},
    Value{"voice.opens_db", -80, 0, KAORI_NUMBER(voice.opens_db)},
    Value{"sound.delay_ms", -1, 500, KAORI_NUMBER(voice.sound_delay_ms)},
};

#undef KAORI_NUMBER
#undef KAORI_LEVEL

static_assert(kValues.size() == kSettingCount);

std::string_view Trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

// The complaint about a value, or nothing.
std::string TakeValue(std::string_view name, float number, LipSettings& into) {
  for (const Value& value : kValues) {
    if (value.name != name) continue;
    if (!(number >= value.low && number <= value.high))
      return fmt::format("{} is not between {} and {}", name, value.low, value.high);
    value.set(into, number);
    return {};
  }
  return fmt::format("{} is not known", name);
}

bool AreBackwards(const Extents& extents) {
  return extents.shut >= extents.open;
}

// The complaint about a line, or nothing.
std::string TakeLine(std::string_view line, LipSettings& into) {
  line = Trimmed(line.substr(0, line.find('#')));
  if (line.empty()) return {};
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) return "a name, = and a number are wanted";
  const std::string_view name = Trimmed(line.substr(0, equals));
  const std::string_view text = Trimmed(line.substr(equals + 1));
  float number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return fmt::format("{} is no number", text);
  return TakeValue(name, number, into);
}

}  // namespace

SettingRange RangeOf(std::size_t setting) {
  const Value& value = kValues[setting];
  return {value.name, value.low, value.high};
}

float ValueOf(const LipSettings& settings, std::size_t setting) {
  return kValues[setting].get(settings);
}

Result<LipSettings> WithValue(const LipSettings& settings, std::string_view name, float value) {
  LipSettings changed = settings;
  const std::string complaint = TakeValue(name, value, changed);
  if (!complaint.empty()) return FailInput(complaint);
  if (AreBackwards(changed.gauge.extents)) return FailInput("mouth.shut is not below mouth.open");
  return changed;
}

std::string LipSettingsText(const LipSettings& settings) {
  std::string text = "# How the lips are seen. Lengths are in widths of the mouth at rest.\n";
  for (const Value& value : kValues) text += fmt::format("{} = {}\n", value.name, value.get(settings));
  return text;
}

Result<LipSettings> ParseLipSettings(std::string_view text, const std::string& name) {
  LipSettings settings;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string complaint = TakeLine(text.substr(0, end), settings);
    if (!complaint.empty()) return FailInput(fmt::format("{}:{}: {}", name, number, complaint));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (AreBackwards(settings.gauge.extents))
    return FailInput(fmt::format("{}: mouth.shut is not below mouth.open", name));
  return settings;
}

Result<LipSettings> ReadLipSettings(const std::filesystem::path& file) {
  const auto text = ReadFile(file);
  if (!text) return tl::unexpected(text.error());
  return ParseLipSettings(*text, file.string());
}

Result<void> WriteLipSettings(const std::filesystem::path& file, const LipSettings& settings) {
  return WriteWholeFile(file, {AsBytes(LipSettingsText(settings))});
}

}  // namespace kaori::lips
