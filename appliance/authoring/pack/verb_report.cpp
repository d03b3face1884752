#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "appliance/authoring/pack/verbs.h"
#include "appliance/authoring/report/report.h"
#include "appliance/programs/stage/logged_show.h"
#include "drivers/base/log.h"
#include "drivers/base/program.h"
#include "drivers/base/whole_file.h"

namespace kaori::authoring {
namespace {

// One for each file, in the order of the command line, without those that cannot be read.
using Logs = std::vector<showlog::LogFile>;

// Reads all logs and plays them again, evening by evening. The oldest comes first.
std::vector<Evening> EveningsOf(const Logs& logs, const show::Show& show) {
  std::vector<Evening> evenings;
  for (std::size_t i = 0; i < logs.size();) {
    std::vector<const showlog::LogFile*> one;
    const showlog::LogHead& first = logs[i].head();
    // A restart of the stage begins a new file; the box's own start is what separates two evenings.
    for (; i < logs.size() && showlog::IsSameEvening(logs[i].head(), first); ++i) one.push_back(&logs[i]);
    evenings.push_back(ReadEvening(one, show));
  }
  return evenings;
}

// The last log is the evening that is told, and must be readable; an earlier one that is not is left out with
// a warning. All of them are played with the show of the last one, so that cues are compared by one list.
int RunReport(const Arguments& arguments) {
  Logs logs;
  for (std::size_t i = 1; i < arguments.words.size(); ++i) {
    auto log = showlog::LogFile::Read(arguments.words[i]);
    if (!log && i + 1 == arguments.words.size()) return ExitWithError(log.error());
    if (log)
      logs.push_back(std::move(*log));
    else
      LogWarning("{}", log.error().message());  // An earlier evening: it is compared without it.
  }
  const auto own = arguments.options.find("--own");
  const auto show = stage::LoadShowOfLog(arguments.words[0], logs.back().head(),
                                         own == arguments.options.end() ? "" : own->second);
  if (!show) return ExitWithError(show.error());
  auto evenings = EveningsOf(logs, *show);
  const Evening evening = std::move(evenings.back());
  evenings.pop_back();
  // The evenings that are left are the earlier ones, which say what is usual.
  const Report report = ReportOf(evening, evenings, *show);
  fmt::print("{}", TextOfReport(report));
  const auto html = arguments.options.find("--html");
  if (html == arguments.options.end()) return 0;
  const std::string page = PageOfReport(report);
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
