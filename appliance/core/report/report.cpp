#include "appliance/core/report/report.h"

#include <cmath>

#include <fmt/format.h>

namespace kaori::report {
namespace {

// Minutes and seconds: "12:07"; hours come before them where there are any.
std::string Length(Duration length) {
  const auto s = static_cast<long>(std::lround(Seconds(length)));
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

// "+0:12": later than usual.
std::string Later(Duration than_usual) {
  const bool early = than_usual < Duration{};
  return (early ? "-" : "+") + Length(early ? -than_usual : than_usual);
}

// "-" stands for cues before the first that names an act.
ReportTable Acts(const Evening& evening) {
  ReportTable table{
      "Acts", {"act", "begins", "length", "until the next, or the end"}, {}, "No cue was played."};
  for (const ActPlayed& act : evening.acts)
    table.rows.push_back(
        {act.act.empty() ? "-" : act.act, act.begins, Length(act.length), Length(act.until_next)});
  return table;
}

// A cue that was played again is told as such and not compared, since its usual time is that of the first.
// Where no earlier evening played it the columns "usual" and "later" stay empty.
ReportTable Cues(const Evening& evening, std::span<const Evening> earlier, const show::Show& show) {
  ReportTable table{"Cues",
                    {"cue", "name", "played at", "called by", "in its act", "usual", "later"},
                    {},
                    "No cue was played."};
  const auto times = TimesInActs(evening, show), usual = UsualTimes(earlier, show);
  std::map<std::size_t, int> played_before;
  for (const PlayedCue& played : evening.cues) {
    const show::Cue& cue = show.cue_list.cues[played.cue];
    std::vector<std::string> row{cue.number, cue.name, played.clock, played.by, "", "", ""};
    const auto expected = usual.find(played.cue);
    if (played_before[played.cue]++ == 0) {
      row[4] = Length(times.at(played.cue));
      if (expected != usual.end()) {
        row[5] = Length(expected->second);
        row[6] = Later(times.at(played.cue) - expected->second);
      }
    } else {
      row[4] = "again";
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable Incidents(std::string title, const std::vector<Incident>& incidents, std::string none) {
  ReportTable table{std::move(title), {"at", "what"}, {}, std::move(none)};
  for (const Incident& incident : incidents) table.rows.push_back({incident.clock, incident.what});
  return table;
}

}  // namespace

// Lines first, which say how the evening was as a whole; then tables of acts, cues, refused GOs and faults.
// What is wrong with the log itself has a table only where there is something.
Report ReportOf(const Evening& evening, std::span<const Evening> earlier, const show::Show& show) {
  Report report{.title = fmt::format("{}, {}", show.name, evening.day), .lines = {}, .tables = {}};
  report.lines.push_back(fmt::format("From {} to {}: {}, {} frames.", evening.begins, evening.ends,
                                     Length(evening.length), evening.frames));
  if (!evening.box.empty()) report.lines.push_back(fmt::format("It was played by the box {}.", evening.box));
  if (evening.line_checks.empty()) report.lines.push_back("No line check was made.");
  for (const Incident& check : evening.line_checks)
    report.lines.push_back(fmt::format("Line check at {}: {}.", check.clock, check.what));
  std::size_t called = 0;
  for (const PlayedCue& played : evening.cues) called += played.chain ? 0 : 1;
  report.lines.push_back(
      fmt::format("{} cues were played, {} of them called by a person.", evening.cues.size(), called));
  report.lines.push_back(earlier.empty()
                             ? "There is no earlier evening to compare with."
                             : fmt::format("Usual is the median of {} earlier evenings.", earlier.size()));
  report.lines.push_back(
      evening.hand_to_scanout.frames == 0
          ? "No control was moved."
          : fmt::format("Hand to scan-out: {:.1f} ms (median), {:.1f} ms (p99), over {} frames.",
                        evening.hand_to_scanout.median_ms, evening.hand_to_scanout.p99_ms,
                        evening.hand_to_scanout.frames));
  if (const Delays& lips = evening.lips_to_scanout; lips.frames > 0)
    report.lines.push_back(
        fmt::format("Lips to scan-out: {:.1f} ms (median), {:.1f} ms (p99), over {} pictures.",
                    lips.median_ms, lips.p99_ms, lips.frames));
  report.lines.push_back(
      evening.frames_that_differ == 0
          ? "The log plays again to the bit."
          : fmt::format(
                "{} frames of the log play otherwise than they did: another show, roles or processor.",
                evening.frames_that_differ));
  report.tables.push_back(Acts(evening));
  report.tables.push_back(Cues(evening, earlier, show));
  report.tables.push_back(Incidents("GOs that were refused", evening.refused, "None."));
  report.tables.push_back(Incidents("Faults", evening.incidents, "None."));
  if (!evening.faults.empty()) {
    ReportTable table{"The log itself", {"what"}, {}, ""};
    for (const std::string& fault : evening.faults) table.rows.push_back({fault});
    report.tables.push_back(std::move(table));
  }
  return report;
}

}  // namespace kaori::report
