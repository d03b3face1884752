#include "appliance/programs/desk/state_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "appliance/core/board/mouth.h"
#include "drivers/base/json.h"

namespace kaori::desk {
namespace {

// Rounded finer than the page draws, so that nearly equal states give equal text. Three digits are a
// thousandth of a mouth's width.
double Rounded(float value) {
  return std::round(static_cast<double>(value) * 1e3) / 1e3;
}

// What is seen (sizes, quality, age) and what the face makes of it (open, wide).
json::Object MouthJson(const DeskFacts& facts) {
  const board::Lips& lips = facts.lips.value;
  const board::MouthPosition mouth = board::PositionOf(lips);
  const double age_ms = Seconds(facts.now - facts.lips.at) * 1e3;
  return {{"height", Rounded(lips.height)},
          {"width", Rounded(lips.width)},
          {"opening", Rounded(lips.opening)},
          {"quality", Rounded(lips.quality)},
          {"age_ms", std::round(std::clamp(age_ms, 0.0, 99'999.0))},
          {"learnable", board::IsLearnable(lips)},
          {"open", Rounded(mouth.open)},
          {"wide", Rounded(mouth.wide)}};
}

// Ranges go with the values, so that the page's sliders know nothing by themselves.
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

// The box is null where no mouth is seen, which the report says by an empty one.
json::Object ReportJson(const lips::Report& report) {
  json::List done;
  for (int step = 0; step < lips::kStepCount; ++step)
    if ((report.done >> step & 1U) != 0)
      done.emplace_back(lips::NameOf(static_cast<lips::CalibrationStep>(step)));
  json::Value box;
  if (report.box[2] > report.box[0])
    box = json::ListOf(std::array{Rounded(report.box[0]), Rounded(report.box[1]), Rounded(report.box[2]),
                                  Rounded(report.box[3])});
  return {{"answered", report.answered},
          {"complaint", report.complaint},
          {"step", report.step ? json::Value(lips::NameOf(*report.step)) : json::Value()},
          {"progress", Rounded(report.progress)},
          {"done", done},
          {"changes", report.changes},
          {"unsaved", report.unsaved},
          {"saved", report.saved},
          {"before", report.before},
          {"exposure_free", report.exposure_free},
          {"box", box},
          {"settings", SettingsJson(report)}};
}

// "ja", "ja-JP" and "ja;q=0.8" name the language "ja"; "jam" does not.
bool NamesLanguage(std::string_view entry, std::string_view language) {
  return entry.starts_with(language) &&
         (entry.size() == language.size() || entry[language.size()] == '-' || entry[language.size()] == ';');
}

// The quality value of one entry of Accept-Language, such as 0.8 of "ja-JP;q=0.8" (RFC 9110, 12.4.2).
double WeightOf(std::string_view entry) {
  const auto q = entry.find("q=");
  if (q == std::string_view::npos) return 1;
  double weight = 0;
  std::from_chars(entry.data() + q + 2, entry.data() + entry.size(), weight);
  return weight;
}

}  // namespace

// The age when presented is that of a stage which draws: a status of two seconds ago says nothing of now.
std::string StateJson(const DeskFacts& facts) {
  constexpr std::array<const char*, 3> kStates{"absent", "live", "stale"};
  const board::StageStatus& stage = facts.stage.value;
  const bool presented = facts.stage.source == board::SourceState::kLive && stage.lips_age > Duration{} &&
                         facts.now - facts.stage.at < std::chrono::seconds(2);
  return json::Write(
      json::Object{{"lips", facts.report.has_value()},
                   {"camera", kStates[static_cast<std::size_t>(facts.lips.source)]},
                   {"mouth", MouthJson(facts)},
                   {"presented_age_ms",
                    presented ? json::Value(std::round(Seconds(stage.lips_age) * 1e3)) : json::Value()},
                   {"picture", facts.picture},
                   {"report", facts.report ? json::Value(ReportJson(*facts.report)) : json::Value()}});
}

// Entries come in any order, and a language that is not named has a weight of 0. On equal weights, as with no
// header at all, the page is English.
bool PrefersJapanese(std::string_view accept_language) {
  double japanese = 0, english = 0;
  while (!accept_language.empty()) {
    const auto end = std::min(accept_language.find(','), accept_language.size());
    std::string_view entry = accept_language.substr(0, end);
    while (!entry.empty() && entry.front() == ' ') entry.remove_prefix(1);
    if (NamesLanguage(entry, "ja")) japanese = std::max(japanese, WeightOf(entry));
    if (NamesLanguage(entry, "en")) english = std::max(english, WeightOf(entry));
    accept_language.remove_prefix(std::min(end + 1, accept_language.size()));
  }
  return japanese > english;
}

}  // namespace kaori::desk
