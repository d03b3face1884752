// The box makes its show reports by itself.
#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/stick_scene.h"

namespace kaori::hil {
namespace {

// The log has its first part on the disk after 30 s, and a report is made 40 s after the key at the latest; the rest is
// for an emulated machine on a busy computer.
constexpr Duration kLongestReport = std::chrono::seconds(240);
constexpr const char* kSaidOfReports =
    "own /usr/bin/journalctl -b --no-pager -o cat -n 100 -u kaori-report.service";
constexpr std::string_view kWritten = "the show report is written: ";

// What the box says it has written: how often, and the file that it wrote last.
struct WrittenReports {
  int times = 0;
  std::string last{};
};

WrittenReports ReportsOf(Scene& scene) {
  const std::string said = TextInBox(scene, kSaidOfReports);
  WrittenReports reports;
  for (auto at = said.find(kWritten); at != std::string::npos; at = said.find(kWritten, at + 1)) {
    const auto from = at + kWritten.size();
    reports = {reports.times + 1, said.substr(from, said.find('\n', from) - from)};
  }
  return reports;
}

// One is written since: of those before nothing is known but that they were. Errors: invalid_argument, none is written,
// or it tells of no evening.
Result<void> WantReport(Scene& scene, int before) {
  std::string file;
  const auto written = [&] {
    const WrittenReports reports = ReportsOf(scene);
    file = reports.last;
    return reports.times > before;
  };
  if (!scene.target.Until(written, kLongestReport)) {
    scene.finding.texts.emplace_back("what the box said of reports", TextInBox(scene, kSaidOfReports));
    return FailInput("the service key is on, and no show report is written");
  }
  const std::string report = TextInBox(scene, "read " + file);
  scene.finding.texts.emplace_back("the show report", report);
  if (report.find(" frames.") == std::string::npos || report.find("Cues\n") == std::string::npos)
    return FailInput("the show report tells of no evening");
  scene.finding.said = fmt::format("the box wrote {} by itself when the service key was turned on", file);
  return {};
}

// The key is turned back in each case, since the next check finds the bridge as it was left.
Result<void> ReportByItself(Scene& scene) {
  const int before = ReportsOf(scene).times;
  scene.target.rig().gpio().Close(kStickKey);
  auto ok = WantReport(scene, before);
  scene.target.rig().gpio().Open(kStickKey);
  return ok;
}

}  // namespace

std::vector<Check> ReportChecks() {
  return {{"show-report",
           "The box writes the show report of the evening by itself",
           false,
           ReportByItself,
           {},
           "kaori-report.service"}};
}

}  // namespace kaori::hil
