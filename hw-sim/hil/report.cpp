#include "hw-sim/hil/report.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "drivers/base/markup.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::hil {
namespace {

// Of the file of figures: an object with a list of names for each check.
constexpr const char* kFiguresOfChecks = "figures_of_checks";

// Removes what the check measured in any run. What it says now counts too: older files have no list of its names.
void RemoveFigures(const ReportedCheck& check, nlohmann::json& figures) {
  if (const auto& lists = figures[kFiguresOfChecks]; lists.is_object() && lists.contains(check.name))
    for (const auto& name : lists[check.name])
      if (name.is_string()) figures.erase(name.get<std::string>());
  for (const auto& [name, value] : check.finding.Measured()) figures.erase(name);
}

// Beside those of others, with the check's name.
void AddFigures(const ReportedCheck& check, nlohmann::json& figures) {
  auto names = nlohmann::json::array();
  for (const auto& [name, value] : check.finding.Measured()) {
    figures[name] = value;
    names.push_back(name);
  }
  if (names.empty()) return;
  figures[kFiguresOfChecks][check.name] = std::move(names);
}

// JUnit has no place for what a passed test saw but its output.
std::string Case(const ReportedCheck& check) {
  const std::string head = fmt::format(R"(    <testcase classname="bench" name="{}: {}" time="{:.1f}")",
                                       Escaped(check.name), Escaped(check.sentence), check.finding.took_s);
  const std::string said = Escaped(check.finding.Said());
  switch (check.finding.verdict) {
    case Verdict::kFailed:
      return fmt::format("{}><failure message=\"{}\"/></testcase>\n", head, said);
    case Verdict::kSkipped:
      return fmt::format("{}><skipped message=\"{}\"/></testcase>\n", head, said);
    default:
      return fmt::format("{}><system-out>{}</system-out></testcase>\n", head, said);
  }
}

}  // namespace

int Report::count(Verdict verdict) const {
  return static_cast<int>(
      std::ranges::count(checks, verdict, [](const ReportedCheck& check) { return check.finding.verdict; }));
}

// As tools of continuous integration read it: `time` is in seconds, and a skipped
// test is neither passed nor failed.
std::string AsJUnit(const Report& report) {
  double took_s = 0;
  std::string cases;
  for (const ReportedCheck& check : report.checks) {
    took_s += check.finding.took_s;
    cases += Case(check);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      "  <testsuite name=\"kaori-bench\" tests=\"{}\" failures=\"{}\" skipped=\"{}\" time=\"{:.1f}\">\n{}  "
      "</testsuite>\n</testsuites>\n",
      report.checks.size(), report.count(Verdict::kFailed), report.count(Verdict::kSkipped), took_s, cases);
}

// Letters that may stand in any file's name; a run of others is one hyphen.
std::string TextFile(const std::string& check, const std::string& text) {
  std::string name = check + "-";
  for (const char letter : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0;
    if (plain || name.back() != '-') name += plain ? letter : '-';
  }
  return name + ".txt";
}

// Texts come before the page that links to them.
// A write that fails ends it: what was written until then stays in the folder.
Result<void> WriteReport(const Report& report, const std::string& folder) {
  for (const ReportedCheck& check : report.checks)
    for (const auto& [name, text] : check.finding.texts)
      if (auto ok = WriteWholeFile(folder + "/" + TextFile(check.name, name), {AsBytes(text)}); !ok)
        return ok;
  if (auto ok = WriteWholeFile(folder + "/report.xml", {AsBytes(AsJUnit(report))}); !ok) return ok;
  return WriteWholeFile(folder + "/report.html", {AsBytes(AsPage(report))});
}

// Of two figures with one name the later check's stays. What was never a list of names is made one.
Result<void> MergeFigures(const Report& report, const std::string& path) {
  auto figures = nlohmann::json::object();
  // A file that is not there is an empty object; one that cannot be read is
  // an error, lest it be replaced.
  if (const auto text = ReadFile(path, {.most_levels = kMostLevels}))
    figures = nlohmann::json::parse(*text, nullptr, false);
  else if (text.error().cause != std::errc::no_such_file_or_directory)
    return tl::unexpected(text.error());
  if (!figures.is_object()) return FailInput(path + " is not a JSON object");
  if (!figures[kFiguresOfChecks].is_object()) figures[kFiguresOfChecks] = nlohmann::json::object();
  for (const ReportedCheck& check : report.checks) {
    if (check.finding.verdict == Verdict::kSkipped) continue;
    RemoveFigures(check, figures);
    figures[kFiguresOfChecks].erase(check.name);
    if (check.finding.verdict == Verdict::kPassed) AddFigures(check, figures);
  }
  if (report.boot_s > 0) figures["first_frames_s"] = report.boot_s;
  return WriteWholeFile(path, {AsBytes(figures.dump(2) + "\n")});
}

}  // namespace kaori::hil
