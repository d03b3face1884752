#include "appliance/programs/desk/state_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "drivers/base/json.h"

namespace kaori::desk {
namespace {

// Finer than the page draws; equal states give equal text.
double Rounded(float value) {
  return std::round(static_cast<double>(value) * 1e3) / 1e3;
}

float Fraction(float value, float low, float high) {
  return std::clamp((value - low) / std::max(high - low, 0.01F), 0.0F, 1.0F);
}

// As the mouth on the stage takes it: at rest in the middle, however much farther one way than the other.
float Stretch(const board::Lips& lips) {
  return lips.width < 1 ? 0.5F * Fraction(lips.width, lips.narrow, 1)
                        : 0.5F + 0.5F * Fraction(lips.width, 1, lips.wide);
}

json::Object MouthJson(const DeskFacts& facts) {
  const board::Lips& lips = facts.lips.value;
  const double age_ms = Seconds(facts.now - facts.lips.at) * 1e3;
  return {{"height", Rounded(lips.height)},
          {"width", Rounded(lips.width)},
          {"opening", Rounded(lips.opening)},
          {"quality", Rounded(lips.quality)},
          {"age_ms", std::round(std::clamp(age_ms, 0.0, 99'999.0))},
          {"open", Rounded(Fraction(lips.height, lips.shut, lips.open))},
          {"wide", Rounded(Stretch(lips))}};
}

json::Object SettingsJson(const lips::Report& report) {
  json::Object settings;
  for (std::size_t n = 0; n < lips::kSettingCount; ++n) {
    const lips::SettingRange range = lips::RangeOf(n);
    settings.emplace_back(range.name, json::Object{{"value", Rounded(report.values[n])},
                                                   {"low", Rounded(range.low)},
                                                   {"high", Rounded(range.high)}});
  }
  return settings;
}

json::Object ReportJson(const lips::Report& report) {
  json::List taken;
  for (int step = 0; step < lips::kStepCount; ++step)
    if ((report.taken >> step & 1U) != 0)
      taken.emplace_back(lips::NameOf(static_cast<lips::CalibrationStep>(step)));
  json::Value box;
  if (report.box[2] > report.box[0])
    box = json::ListOf(std::array{Rounded(report.box[0]), Rounded(report.box[1]), Rounded(report.box[2]),
                                  Rounded(report.box[3])});
  return {{"answered", report.answered},
          {"complaint", report.complaint},
          {"step", report.step ? json::Value(lips::NameOf(*report.step)) : json::Value()},
          {"progress", Rounded(report.progress)},
          {"taken", taken},
          {"changes", report.changes},
          {"unsaved", report.unsaved},
          {"saved", report.saved},
          {"before", report.before},
          {"free_light", report.free_light},
          {"box", box},
          {"settings", SettingsJson(report)}};
}

// "ja", "ja-JP" and "ja;q=0.8" are of "ja"; "jam" is not.
bool IsOf(std::string_view entry, std::string_view language) {
  return entry.starts_with(language) &&
         (entry.size() == language.size() || entry[language.size()] == '-' || entry[language.size()] == ';');
}

// How much one entry of Accept-Language ("ja-JP;q=0.8") is wanted.
double WeightOf(std::string_view entry) {
  const auto q = entry.find("q=");
  if (q == std::string_view::npos) return 1;
  double weight = 0;
  std::from_chars(entry.data() + q + 2, entry.data() + entry.size(), weight);
  return weight;
}

}  // namespace

std::string StateJson(const DeskFacts& facts) {
  constexpr std::array<const char*, 3> kStates{"absent", "live", "stale"};
  const board::StageStatus& stage = facts.stage.value;
  const bool lit = facts.stage.source == board::SourceState::kLive && stage.lips_age > Duration{} &&
                   facts.now - facts.stage.at < std::chrono::seconds(2);
  return json::Write(
      json::Object{{"lips", facts.report.has_value()},
                   {"camera", kStates[static_cast<std::size_t>(facts.lips.source)]},
                   {"mouth", MouthJson(facts)},
                   {"light_age_ms", lit ? json::Value(std::round(Seconds(stage.lips_age) * 1e3)) : json::Value()},
                   {"picture", facts.picture},
                   {"report", facts.report ? json::Value(ReportJson(*facts.report)) : json::Value()}});
}

bool PrefersJapanese(std::string_view accept_language) {
  double japanese = 0, english = 0;
  while (!accept_language.empty()) {
    const auto end = std::min(accept_language.find(','), accept_language.size());
    std::string_view entry = accept_language.substr(0, end);
    while (!entry.empty() && entry.front() == ' ') entry.remove_prefix(1);
    if (IsOf(entry, "ja")) japanese = std::max(japanese, WeightOf(entry));
    if (IsOf(entry, "en")) english = std::max(english, WeightOf(entry));
    accept_language.remove_prefix(std::min(end + 1, accept_language.size()));
  }
  return japanese > english;
}

}  // namespace kaori::desk
