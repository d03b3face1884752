#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "appliance/authoring/pack/verbs.h"
#include "appliance/core/report/report.h"
#include "appliance/programs/report/logged_show.h"
#include "drivers/base/log.h"
#include "drivers/base/program.h"
#include "drivers/base/whole_file.h"

namespace kaori::authoring {
namespace {

// The last log is the evening that is told, and must be readable; an earlier one that is not is left out with
// a warning. All of them are played with the show of the last one, so that cues are compared by one list.
int RunReport(const Arguments& arguments) {
  std::vector<showlog::LogFile> logs;
  for (std::size_t i = 1; i < arguments.words.size(); ++i) {
    auto log = showlog::LogFile::Read(arguments.words[i]);
    if (!log && i + 1 == arguments.words.size()) return ExitWithError(log.error());
    if (log)
      logs.push_back(std::move(*log));
    else
      LogWarning("{}", log.error().message());  // An earlier evening: it is compared without it.
  }
  const auto own = arguments.options.find("--own");
  const auto show = report::LoadShowOfLog(arguments.words[0], logs.back().head(),
                                          own == arguments.options.end() ? "" : own->second);
  if (!show) return ExitWithError(show.error());
  auto evenings = report::ReadEvenings(logs, *show);
  const report::Evening evening = std::move(evenings.back());
  evenings.pop_back();
  // The evenings that are left are the earlier ones, which say what is usual.
  const report::Report told = report::ReportOf(evening, evenings, *show);
  fmt::print("{}", report::TextOfReport(told));
  const auto html = arguments.options.find("--html");
  if (html == arguments.options.end()) return 0;
  const std::string page = report::PageOfReport(told);
  if (const auto ok = WriteWholeFile(html->second, {AsBytes(page)}); !ok) return ExitWithError(ok.error());
  return 0;
}

}  // namespace

Verb ReportVerb() {
  return {.name = "report",
          .words = {"PACK", "LOG..."},
          .options = {{"--html", "FILE"}, {"--own", "FOLDER"}},
          .summary = "the show report of an evening, from its show log",
          .page = R"(
Plays the log again with the show that was played, and says what happened: acts and intervals, each cue with its time and
who called it, refused GOs, devices that were lost, and how long a hand takes to the screen. The last LOG is the evening;
those before it say what is usual. Logs that lie between two starts of the box are one evening.

  --html FILE   the same as a page that a browser prints
  --own FOLDER  where the box keeps expressions that were made on it, if the show calls them
)",
          .run = RunReport};
}

}  // namespace kaori::authoring
