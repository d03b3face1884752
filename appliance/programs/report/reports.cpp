#include "appliance/programs/report/reports.h"

#include <algorithm>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "appliance/core/last_face/show_mark.h"
#include "appliance/core/report/report.h"
#include "appliance/core/showlog/log_file.h"
#include "appliance/core/showlog/log_folder.h"
#include "appliance/core/store/choice.h"
#include "appliance/programs/report/logged_show.h"
#include "appliance/programs/report/own_copy.h"
#include "drivers/base/folder.h"
#include "drivers/base/whole_file.h"

namespace kaori::report {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kForTheGroup = 0640;  // As the logs themselves.

// The logs of one switching on of the box, the oldest first.
using LogsOfEvening = std::span<const showlog::LogOnDisk>;

std::vector<LogsOfEvening> EveningsIn(std::span<const showlog::LogOnDisk> logs) {
  std::vector<LogsOfEvening> evenings;
  for (std::size_t from = 0; from < logs.size();) {
    std::size_t to = from + 1;
    while (to < logs.size() && showlog::IsSameEvening(logs[from].head, logs[to].head)) ++to;
    evenings.push_back(logs.subspan(from, to - from));
    from = to;
  }
  return evenings;
}

fs::path ReportFile(const LogsOfEvening& evening, const char* ending) {
  return fs::path(evening.front().file).replace_extension(ending);
}

// A log that grows is newer than its report.
bool HasReport(const LogsOfEvening& evening) {
  std::error_code none, odd;
  const auto made = fs::last_write_time(ReportFile(evening, kTextEnding), none);
  return !none && std::ranges::none_of(evening, [&](const showlog::LogOnDisk& log) {
    return fs::last_write_time(log.file, odd) > made;
  });
}

// The packs with this mark, of those that the box has: the copy of its own show has the mark of that.
std::vector<fs::path> PacksOf(std::uint64_t mark, const ReportPlaces& places) {
  std::vector<fs::path> packs;
  for (const fs::path& place : places.packs) {
    std::error_code odd;
    if (!fs::is_directory(place, odd)) {
      packs.push_back(place);
      continue;
    }
    for (const fs::path& file : ListFolder(place).value_or(std::vector<fs::path>{}))
      if (file.extension() == ".kaori" || file.filename() == store::kCopyName) packs.push_back(file);
  }
  std::erase_if(packs, [&](const fs::path& pack) {
    const auto of_pack = last_face::ShowMark(pack);
    return !of_pack || *of_pack != mark;
  });
  return packs;
}

// From the first of its packs that can be read: the disk may have spoilt one. Errors: as LoadShowOfLog, of the last one.
Result<show::Show> LoadPlayed(const showlog::LogHead& head, const ReportPlaces& places, const fs::path& own) {
  Result<show::Show> played = FailInput("the show that was played is no longer on the box");
  for (const fs::path& pack : PacksOf(head.show, places))
    if (played = LoadShowOfLog(pack, head, own); played) break;
  return played;
}

// The evenings up to this one that were played with its show. The last one must be readable as a whole; of others what
// cannot be read is left out.
Result<std::vector<showlog::LogFile>> ReadLogs(std::span<const LogsOfEvening> evenings) {
  const auto show = evenings.back().front().head->show;
  std::vector<showlog::LogFile> logs;
  for (const LogsOfEvening& evening : evenings)
    for (const showlog::LogOnDisk& log : evening) {
      if (!log.head || log.head->show != show) continue;
      auto read = showlog::LogFile::Read(log.file);
      if (!read && &evening == &evenings.back()) return tl::unexpected(read.error());
      if (read) logs.push_back(std::move(*read));
    }
  return logs;
}

// The last of `evenings`, compared with those before it.
Result<void> MakeReport(std::span<const LogsOfEvening> evenings, const ReportPlaces& places) {
  const LogsOfEvening& evening = evenings.back();
  const std::string name = evening.front().file.string();
  if (!evening.front().head)
    return FailInput(name + ": it is no show log, or of another version of the programs");
  const auto logs = ReadLogs(evenings);
  if (!logs) return tl::unexpected(logs.error());
  const TemporaryFolder own;
  CopyOwn(places.own, own.path());
  const auto show = LoadPlayed(logs->back().head(), places, own.path());
  if (!show) return FailAs(show.error(), name + ": " + show.error().attempt);
  auto told = ReadEvenings(*logs, *show);
  const Evening last = std::move(told.back());
  told.pop_back();
  const Report report = ReportOf(last, told, *show);
  // The text comes last: while it is missing or old the report is made anew.
  for (const auto& [ending, words] :
       {std::pair(kPageEnding, PageOfReport(report)), std::pair(kTextEnding, TextOfReport(report))})
    if (auto ok = WriteWholeFile(ReportFile(evening, ending), {AsBytes(words)}, kForTheGroup); !ok) return ok;
  return {};
}

// Names begin with the log's number and its day, so that their order is that of the evenings.
void RemoveOldReports(const fs::path& folder) {
  auto files = ListFolder(folder).value_or(std::vector<fs::path>{});
  std::erase_if(files, [](const fs::path& file) {
    const std::string name = file.filename().string();
    return !name.ends_with(kTextEnding) && !name.ends_with(kPageEnding);
  });
  std::uintmax_t bytes = 0;
  std::error_code none;
  for (auto file = files.rbegin(); file != files.rend(); ++file) {
    bytes += fs::file_size(*file, none);
    if (bytes > kMostKept_bytes) fs::remove(*file, none);
  }
}

}  // namespace

MadeReports MakeReports(const ReportPlaces& places) {
  MadeReports made;
  const auto logs = showlog::LogsIn(places.logs);
  const auto evenings = EveningsIn(logs);
  for (std::size_t i = 0; i < evenings.size(); ++i) {
    if (HasReport(evenings[i])) continue;
    const auto ok = MakeReport(std::span(evenings).first(i + 1), places);
    if (ok)
      made.files.push_back(ReportFile(evenings[i], kTextEnding));
    else
      made.faults.push_back(ok.error().message());
  }
  RemoveOldReports(places.logs);
  return made;
}

}  // namespace kaori::report
